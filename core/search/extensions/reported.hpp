#pragma once

/// What the settings of the seven extensions have in common.

namespace asv::core {

inline constexpr const char* extensions_report = "report on seven extensions";
inline constexpr const char* extension_is_off =
    "off leaves RRT-Connect as published; no extension is a clear win on the testcases";

}  // namespace asv::core
