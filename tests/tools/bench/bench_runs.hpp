#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/kit/files/run_program.hpp"

namespace asv::test {

using Words = std::vector<std::string>;

/// Runs asv-bench with two seeds, unless the options say otherwise, and without progress.
inline Outcome bench(const Words& problems, const Words& options = {},
                     const Surroundings& surroundings = {}) {
    Words arguments = problems;
    arguments.insert(arguments.end(), {"--quiet", "--seeds", "2"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program("asv-bench", arguments, surroundings);
}

/// What no clock and no allocator has a say in.
inline nlohmann::json without_times(nlohmann::json run) {
    for (const char* key : {"time_to_first_s", "time_total_s", "cost_history", "peak_memory_bytes"})
        run.erase(key);
    return run;
}

}  // namespace asv::test
