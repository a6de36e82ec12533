#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace asv::io {

/// What a picture tells of the run that has found a solution.
struct RunFacts {
    std::string planner;                ///< empty when the file does not say
    std::optional<double> lower_bound;  ///< of the cost; none when the file has none, null or 0
};

/// Reads "planner" and "cost_lower_bound" from a file that asv-solve --stats has written. Throws
/// ParseError or ReadError.
RunFacts read_run_facts(const std::filesystem::path& file);

/// The same from text; name stands for the file in messages.
RunFacts parse_run_facts(std::string_view text, const std::string& name);

}  // namespace asv::io
