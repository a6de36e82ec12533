#pragma once

#include <string_view>

namespace asv::io {

/// Writes all bytes to an open descriptor, in as many calls as that takes; false, with errno set,
/// when one fails. Interruptions by signals are waited out.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace asv::io
