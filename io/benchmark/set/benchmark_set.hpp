#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asv::io {

/// A problem of the benchmark set: a line of testcases/set/problems.csv.
struct SetProblem {
    std::string name;   ///< no other problem of the set has it; without blanks
    std::string words;  ///< of asv-generate, which make it
    std::size_t asv_count = 1;
    bool feasible = true;               ///< false: it is proven that there is no path
    std::optional<double> best_cost;    ///< of any valid path that was found; workspace units
    std::optional<double> lower_bound;  ///< no path costs less, proven
    std::string line;                   ///< of the file, without its end

    /// The first of its words.
    std::string_view family() const { return std::string_view(words).substr(0, words.find(' ')); }
};

/// A set from the text of its file: a line of titles, then one for each problem. Throws
/// std::invalid_argument that tells the line that is no problem.
std::vector<SetProblem> parse_set(std::string_view text);

/// All of the set that this program was built with, in the order of the file.
const std::vector<SetProblem>& benchmark_set();

/// Those whose name or family the pattern of a shell (*, ?, [abc]) fits.
std::vector<SetProblem> chosen_of_set(const std::string& pattern);

/// The lines of these problems behind the titles, as the file has them.
std::string format_set(const std::vector<SetProblem>& problems);

}  // namespace asv::io
