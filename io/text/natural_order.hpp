#pragma once

#include <string_view>

namespace asv::io {

/// Does the first text stand before the other one in a list for people? Runs of digits count as
/// numbers ("3ASV" stands before "15ASV"), everything else by its bytes; where that tells no
/// difference ("03" and "3"), bytes decide. A strict order of all texts.
bool naturally_before(std::string_view a, std::string_view b);

}  // namespace asv::io
