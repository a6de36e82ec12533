#pragma once

#include <CLI/CLI.hpp>

#include "io/problem/reading.hpp"

namespace asv::tools {

/// Adds what all programs that read problems have in common.
inline void add_reading_options(CLI::App& app, io::ReadOptions& options) {
    app.add_flag("--allow-maps-anywhere", options.maps_anywhere,
                 "Read a scenario's map also where it is not below the scenario's folder");
}

}  // namespace asv::tools
