#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace asv::io {

/// Files beyond this size, and with them endless devices, are refused.
inline constexpr std::size_t largest_file = std::size_t{1} << 30U;

/// The whole file as bytes; pipes and devices are read to their end. Throws ReadError (missing, a
/// directory, not readable, more than limit bytes).
std::string read_file(const std::filesystem::path& file, std::size_t limit = largest_file);

/// Puts content into a temporary file beside the target, then renames it: the target is either
/// what it was or whole. A new file has the permissions that the umask leaves, an old one keeps
/// its own; a symbolic link stays and its target is replaced. What is no regular file (a device, a
/// pipe, /dev/stdout) is written directly. Throws WriteError (no such folder, a directory, not
/// writable, disk full) and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Throws the WriteError that write_file would meet before it writes: for finding out before an
/// hour of work that its result has no place to go. Changes nothing.
void require_writable(const std::filesystem::path& file);

}  // namespace asv::io
