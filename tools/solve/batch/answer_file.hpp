#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "tools/common/descriptor.hpp"

namespace asv::tools {

/// The answers of a batch, written line by line, so that nothing is lost of what was answered when
/// the process ends: another program may wait for each, and hours of work must not hang on the
/// last query.
class AnswerFile {
  public:
    /// "-" is standard output; a file that exists is emptied. Throws io::WriteError.
    explicit AnswerFile(const std::filesystem::path& file);

    /// A whole line. Throws io::WriteError, and then leaves no part of it in a regular file.
    void write(std::string_view line);

  private:
    [[noreturn]] void fail() const;

    std::string name_;
    Descriptor file_;
    std::size_t size_ = 0;
};

}  // namespace asv::tools
