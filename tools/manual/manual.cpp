#include "tools/manual/manual.hpp"

#include <ostream>
#include <stdexcept>

#include "tools/manual/command.hpp"

namespace asv::tools::manual {

void write(std::ostream& out, std::string_view kind, const CLI::App& app, std::string_view version,
           std::span<const Entry> exit_codes) {
    const Command command = describe(app);
    if (kind == "man")
        out << man_page(command, version, exit_codes);
    else if (kind == "bash")
        out << bash_completion(command);
    else if (kind == "zsh")
        out << zsh_completion(command);
    else if (kind == "fish")
        out << fish_completion(command);
    else
        throw std::invalid_argument("no manual of the kind '" + std::string(kind) + "'");
}

}  // namespace asv::tools::manual
