#pragma once

namespace asv::core {

/// The tolerance of the requirements, by which most cases miss or keep a limit.
inline constexpr double e = 1e-5;

}  // namespace asv::core
