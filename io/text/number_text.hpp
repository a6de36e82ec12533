#pragma once

#include <string>

namespace asv::io {

/// Appends the shortest decimal text that reads back to exactly this value. Precondition: finite.
void append_number(std::string& text, double value);

}  // namespace asv::io
