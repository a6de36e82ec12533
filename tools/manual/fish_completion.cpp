#include <sstream>

#include "tools/manual/command.hpp"
#include "tools/manual/manual.hpp"
#include "tools/manual/planners.hpp"
#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

namespace {

/// What is offered for a value, as fish's `-a` takes it; empty for nothing.
std::string offered(const Value& value, const std::string& function) {
    switch (value.kind) {
        case Value::Kind::file:
            return glued({"(", function, "_files ", joined(value.words, " "), ")"});
        case Value::Kind::folder:
            return "(__fish_complete_directories)";
        case Value::Kind::words:
            return joined(value.words, " ");
        case Value::Kind::planner:
            return glued({joined(value.words, " "), " (", function, "_planners)"});
        case Value::Kind::setting:
            return glued({"(", function, "_settings)"});
        case Value::Kind::none:
        case Value::Kind::other:
            break;
    }
    return "";
}

/// One option; condition: when it is offered, empty for always.
void write_option(std::ostream& out, const std::string& program, const Argument& option,
                  const std::string& condition) {
    out << "complete -c " << program;
    if (!condition.empty()) out << " -n " << quoted_for_fish(condition);
    for (const std::string& name : option.names)
        out << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
    if (option.value.kind != Value::Kind::none) out << " -x";
    out << " -d " << quoted_for_fish(option.description);
    const std::string offer = offered(option.value, glued({"_", function_prefix(program)}));
    if (!offer.empty()) out << " -a " << quoted_for_fish(offer);
    out << '\n';
}

/// Folders, and files with one of the given endings; all files when none is given.
void write_files(std::ostream& out, const std::string& function) {
    out << "function " << function << "_files\n"
        << "    set -l token (string replace -r -- '^--[^=]*=' '' (commandline -ct))\n"
        << "    set -l endings (string join '|' -- (string escape --style=regex -- $argv))\n"
        << "    __fish_complete_path \"$token\" | string match -r -- "
           "\".*(?:/|$endings)(?:\\t.*)?\\$\"\n"
        << "end\n\n";
}

void write_planners(std::ostream& out, const std::string& function) {
    out << "function " << function << "_planners\n"
        << "    printf '%s\\t%s\\n'";
    for (const PlannerChoice& planner : planner_choices())
        out << " \\\n        " << planner.name << ' ' << quoted_for_fish(planner.summary);
    out << "\nend\n\n";
}

/// KEY= for each setting of the planner that stands in the line, KEY=WORD where there are words.
void write_settings(std::ostream& out, const std::string& function) {
    out << "function " << function << "_settings\n"
        << "    set -l planner auto\n"
        << "    set -l words (commandline -opc)\n"
        << "    for i in (seq (count $words))\n"
        << "        switch $words[$i]\n"
        << "            case --planner\n"
        << "                set -q words[(math $i + 1)]; and set planner $words[(math $i + 1)]\n"
        << "            case '--planner=*'\n"
        << "                set planner (string replace -- --planner= '' $words[$i])\n"
        << "        end\n"
        << "    end\n"
        << "    switch $planner\n";
    for (const PlannerChoice& planner : planner_choices()) {
        out << "        case " << planner.name << '\n' << "            printf '%s\\t%s\\n'";
        for (const SettingChoice& setting : planner.settings) {
            std::vector<std::string> words = setting.words;
            if (words.empty()) words = {""};
            for (const std::string& word : words)
                out << " \\\n                " << setting.name << '=' << word << ' '
                    << quoted_for_fish(setting.meaning);
        }
        out << '\n';
    }
    out << "    end\n"
        << "end\n\n";
}

void write_families(std::ostream& out, const Command& command) {
    std::vector<std::string> names;
    for (const Command& family : command.subcommands) names.push_back(family.name);
    const std::string seen = "__fish_seen_subcommand_from ";
    for (const Command& family : command.subcommands) {
        out << "complete -c " << command.name << " -n "
            << quoted_for_fish("not " + seen + joined(names, " ")) << " -a " << family.name
            << " -d " << quoted_for_fish(family.description) << '\n';
        for (const Argument& option : family.options)
            if (option.names.back() != "--help")
                write_option(out, command.name, option, seen + family.name);
    }
}

}  // namespace

std::string fish_completion(const Command& command) {
    const std::string function = glued({"_", function_prefix(command.name)});
    std::ostringstream out;
    out << "# Made from the options of " << command.name << ", as --help prints them.\n\n";
    write_files(out, function);
    if (takes(command, Value::Kind::planner)) write_planners(out, function);
    if (takes(command, Value::Kind::setting)) write_settings(out, function);
    out << "complete -c " << command.name << " -f\n";
    if (!command.positionals.empty())
        out << "complete -c " << command.name << " -a "
            << quoted_for_fish(offered(command.positionals.front().value, function)) << '\n';
    for (const Argument& option : command.options) write_option(out, command.name, option, "");
    write_families(out, command);
    return out.str();
}

}  // namespace asv::tools::manual
