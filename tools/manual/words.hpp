#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What a manual page says beyond --help.

namespace asv::tools::manual {

/// A term and what is said of it: an exit code, a file, a call of the program.
struct Entry {
    std::string term;
    std::string text;
};

struct Words {
    std::string purpose;                  ///< behind the name, without a full stop
    std::vector<std::string> paragraphs;  ///< of DESCRIPTION, after the one of --help
    std::vector<Entry> files;
    std::vector<Entry> examples;  ///< the call, and what it does
};

/// Of one of our programs. Throws std::invalid_argument for another one.
Words words_of(std::string_view program);

/// The environment variables that all programs obey.
std::vector<Entry> environment_of_all();

}  // namespace asv::tools::manual
