#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace asv::io {

/// What could not be understood, and where. what() reads
/// "FILE:LINE:COLUMN: expected EXPECTED, found FOUND", fit for a terminal whatever the file holds;
/// line and column count from 1, columns in bytes.
class ParseError : public std::runtime_error {
  public:
    ParseError(std::string file, std::size_t line, std::size_t column, std::string expected,
               std::string found);

    const std::string& file() const { return file_; }
    std::size_t line() const { return line_; }
    std::size_t column() const { return column_; }
    const std::string& expected() const { return expected_; }
    const std::string& found() const { return found_; }

  private:
    std::string file_;
    std::size_t line_;
    std::size_t column_;
    std::string expected_;
    std::string found_;
};

/// A file that cannot be opened, read or written: what() reads "FILE: REASON", fit for a terminal.
class FileError : public std::runtime_error {
  public:
    explicit FileError(const std::string& message);
};

/// An input that cannot be opened or read.
class ReadError : public FileError {
  public:
    using FileError::FileError;
};

/// An output that cannot be created or written.
class WriteError : public FileError {
  public:
    using FileError::FileError;
};

}  // namespace asv::io
