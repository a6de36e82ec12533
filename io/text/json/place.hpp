#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asv::io {

/// A place in a text, both counted from 1; columns count bytes.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// Line and column of a byte; offset == text.size() is the end of the text.
TextPlace place_of_offset(std::string_view text, std::size_t offset);

/// Where the value at a JSON pointer ("/trees/0/parents") begins. Where the pointer leads nowhere,
/// the place of the deepest value on its way that exists. Of several members of one name the last
/// counts, as for the parser. Precondition: text is a well-formed JSON document.
TextPlace place_of_value(std::string_view text, std::string_view pointer);

/// The pointer as people write it: "/trees/0/parents" becomes "trees[0].parents", and the empty
/// pointer "the document".
std::string readable_path(std::string_view pointer);

}  // namespace asv::io
