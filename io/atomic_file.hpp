#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asv::io {

/// The whole file as bytes. Throws FileError (missing, a directory, not readable).
std::string read_file(const std::filesystem::path& file);

/// Puts content into a temporary file beside the target, then renames it: the target is either
/// what it was or whole. Throws FileError (no such folder, not writable, disk full) and leaves
/// nothing behind.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace asv::io
