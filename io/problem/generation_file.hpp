#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asv::io {

/// How a generated problem came about, and whether it is known to have a path.
struct Generation {
    std::string problem;  ///< name of the problem file
    std::string family;
    std::size_t asv_count = 0;
    std::size_t obstacle_count = 0;
    std::uint64_t seed = 0;
    std::size_t attempt = 1;  ///< which problem of the seed it is, from 1
    std::vector<std::pair<std::string, std::string>> parameters;  ///< options and their values
    std::string verdict = "unknown";  ///< or "solvable", or "infeasible"
    std::string reason;
    std::string version;
};

/// Writes one JSON object, whole or not at all. Throws WriteError.
void write_generation(const std::filesystem::path& file, const Generation& generation);

/// Those of the parameters that are numbers, in the order of letters.
std::vector<std::pair<std::string, double>> number_parameters(
    const std::vector<std::pair<std::string, std::string>>& parameters);

/// The parameters of that object that are numbers, in the order of letters; of the file all other
/// members are left alone, so that other programs may write one, too. Throws ReadError, ParseError.
std::vector<std::pair<std::string, double>> read_parameters(const std::filesystem::path& file);

}  // namespace asv::io
