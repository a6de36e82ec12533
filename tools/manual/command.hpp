#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The arguments of a program, as manual pages and completions tell them. They are read from the
/// same CLI::App that --help prints, so no option is told twice and none is forgotten.

namespace asv::tools::manual {

/// What an option or a positional argument takes. The kind is told by its type name in CLI11:
///   "FILE.txt|.json"   a file with one of these endings; "FILE" any file
///   "FOLDER"           a folder
///   "PLANNER"          a planner of the catalogue; "PLANNER|all" also that word
///   "KEY=VALUE"        a setting of the planner that is chosen
///   "TEXT:{a,b}"       one of these words, as CLI::IsMember has it; "{a,b}" the same
/// and anything else is a text or a number, for which nothing can be offered.
struct Value {
    enum class Kind { none, file, folder, words, planner, setting, other };
    Kind kind = Kind::none;
    std::string shown;               ///< "FILE", "N", "light|dark"; empty for a switch
    std::vector<std::string> words;  ///< endings of files; words to choose from
};

/// An option, a switch or, without dashes before its name, a positional argument.
struct Argument {
    std::vector<std::string> names;  ///< "-o", "--output"; or "PROBLEM"
    std::string description;
    std::string default_value;  ///< empty where there is none to tell
    Value value;
    bool required = false;
    bool repeatable = false;
};

/// A program, or one of its subcommands.
struct Command {
    std::string name;
    std::string description;
    std::vector<Argument> options;
    std::vector<Argument> positionals;
    std::vector<Command> subcommands;
    std::string footer;  ///< "Example:\n  asv-solve ..."
};

/// What the program's arguments are. Hidden options (of the empty group) are left out.
Command describe(const CLI::App& app);

/// Whether an option of the command takes a value of this kind.
bool takes(const Command& command, Value::Kind kind);

}  // namespace asv::tools::manual
