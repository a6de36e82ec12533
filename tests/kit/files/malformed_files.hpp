#pragma once

#include <string>
#include <vector>

namespace asv::test {

/// A file that cannot be understood.
struct Malformed {
    std::string name;
    std::string content;
    std::string message;  ///< what the error has to say after the file's name
};

/// A small problem that every program understands, line by line.
std::vector<std::string> good_problem();

/// A solution of it that meets every requirement.
std::vector<std::string> good_solution();

std::string joined(const std::vector<std::string>& lines);

std::vector<Malformed> malformed_problems();
std::vector<Malformed> malformed_solutions();

}  // namespace asv::test
