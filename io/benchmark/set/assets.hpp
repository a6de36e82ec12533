#pragma once

#include <string_view>

/// The file of the set as a string, put into the program when it is built (io/embed.cmake).
namespace asv::io::set_assets {

extern const std::string_view problems;  ///< testcases/set/problems.csv

}  // namespace asv::io::set_assets
