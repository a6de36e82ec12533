#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace asv::io {

/// Files beyond this size, and with them endless devices, are refused.
inline constexpr std::size_t largest_file = std::size_t{1} << 30U;

/// The name that stands for standard input, or standard output. A file of that name is "./-".
inline constexpr const char* standard_stream = "-";

/// What messages call an input: "<stdin>" for standard input, else its path.
std::string input_name(const std::filesystem::path& file);

/// Likewise an output.
std::string output_name(const std::filesystem::path& file);

/// The whole file as bytes; pipes and devices are read to their end, "-" is standard input. Throws
/// ReadError (missing, a directory, not readable, more than limit bytes).
std::string read_file(const std::filesystem::path& file, std::size_t limit = largest_file);

/// The same for what must be a regular file: anything else is a ReadError, and never waited for.
std::string read_regular_file(const std::filesystem::path& file, std::size_t limit = largest_file);

/// Writes a new file beside the target, brings it to the disk, and only then gives it the target's
/// name: the target is either what it was or whole, also after a loss of power. A new file has the
/// permissions that the umask leaves; an old one keeps its own and, where the process may, its
/// owner. A symbolic link stays and its target is replaced. What is no regular file (a device, a
/// pipe, /dev/stdout, "-" for standard output) is written directly. Throws WriteError (no such
/// folder, a directory, not writable, disk full, files may not be that large) and leaves nothing
/// behind; where the file system knows nameless files (O_TMPFILE), whatever ends the process.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Throws the WriteError that write_file would meet before it writes: for finding out before an
/// hour of work that its result has no place to go. Changes nothing.
void require_writable(const std::filesystem::path& file);

}  // namespace asv::io
