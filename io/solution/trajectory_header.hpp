#pragma once

#include <cstddef>
#include <string>

namespace asv::io {

/// Of the JSON.
inline constexpr int trajectory_version = 1;

/// The first line of a trajectory as CSV, without its end.
std::string csv_header(std::size_t vehicles);

}  // namespace asv::io
