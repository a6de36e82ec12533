#pragma once

#include <string>
#include <vector>

namespace asv::tools {

/// The words with commas between them, those first that are most like the given one (the fewest
/// letters to put in, leave out or change: Levenshtein, 1966), else in their own order.
std::string listed_by_likeness(std::vector<std::string> words, const std::string& given);

}  // namespace asv::tools
