#pragma once

#include <cstddef>
#include <optional>
#include <string>

/// What the system tells of the machine and of this process.

namespace asv::tools {

std::string host_name();

/// The model of the processor; "unknown processor" where the system does not tell.
std::string cpu_name();

/// The most memory that this process has held, in bytes, resident; none where the system does not
/// tell.
std::optional<std::size_t> peak_memory();

}  // namespace asv::tools
