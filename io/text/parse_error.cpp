#include "io/text/parse_error.hpp"

#include <utility>

namespace asv::io {

ParseError::ParseError(std::string file, std::size_t line, std::size_t column, std::string expected,
                       std::string found)
    : std::runtime_error(file + ":" + std::to_string(line) + ":" + std::to_string(column) +
                         ": expected " + expected + ", found " + found),
      file_(std::move(file)),
      line_(line),
      column_(column),
      expected_(std::move(expected)),
      found_(std::move(found)) {}

}  // namespace asv::io
