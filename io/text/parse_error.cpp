#include "io/text/parse_error.hpp"

#include <utility>

#include "io/text/escape.hpp"

namespace asv::io {

ParseError::ParseError(std::string file, std::size_t line, std::size_t column, std::string expected,
                       std::string found)
    : std::runtime_error(escaped(file + ":" + std::to_string(line) + ":" + std::to_string(column) +
                                 ": expected " + expected + ", found " + found)),
      file_(std::move(file)),
      line_(line),
      column_(column),
      expected_(std::move(expected)),
      found_(std::move(found)) {}

FileError::FileError(const std::string& message) : std::runtime_error(escaped(message)) {}

}  // namespace asv::io
