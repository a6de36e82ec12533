#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "tools/manual/words.hpp"

namespace CLI {
class App;
}

namespace asv::tools::manual {

struct Command;

/// The manual page in roff, for man(1). exit_codes: what the programs tell their caller.
std::string man_page(const Command& command, std::string_view version,
                     std::span<const Entry> exit_codes);

/// Functions that complete the command's options, their values and its files, for bash (with the
/// package bash-completion), zsh and fish.
std::string bash_completion(const Command& command);
std::string zsh_completion(const Command& command);
std::string fish_completion(const Command& command);

/// Writes one of them: kind is "man", "bash", "zsh" or "fish". Throws std::invalid_argument for
/// another kind.
void write(std::ostream& out, std::string_view kind, const CLI::App& app, std::string_view version,
           std::span<const Entry> exit_codes);

}  // namespace asv::tools::manual
