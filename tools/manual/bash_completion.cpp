#include <sstream>

#include "tools/manual/command.hpp"
#include "tools/manual/manual.hpp"
#include "tools/manual/planners.hpp"
#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

namespace {

std::string offer(const std::string& words) {
    return "mapfile -t COMPREPLY < <(compgen -W " + quoted(words) + " -- \"$cur\")";
}

/// The command that completes a value.
std::string action(const Value& value, const std::string& function) {
    switch (value.kind) {
        case Value::Kind::file:
            if (value.words.empty()) return "_filedir";
            return "_filedir " + quoted(joined(without_dots(value.words), "|"));
        case Value::Kind::folder:
            return "_filedir -d";
        case Value::Kind::words:
            return offer(joined(value.words, " "));
        case Value::Kind::planner: {
            std::vector<std::string> names = value.words;
            for (const PlannerChoice& planner : planner_choices()) names.push_back(planner.name);
            return offer(joined(names, " "));
        }
        case Value::Kind::setting:
            return function + "_settings";
        case Value::Kind::none:
        case Value::Kind::other:
            break;
    }
    return ":";
}

/// "--set KEY=VALUE": first the keys of the planner that stands in the line, then the words of one.
void write_settings(std::ostream& out, const std::string& function) {
    out << function << "_settings()\n{\n"
        << "    local planner=auto i\n"
        << "    for ((i = 1; i < ${#words[@]} - 1; i++)); do\n"
        << "        [[ ${words[i]} != --planner ]] || planner=${words[i + 1]}\n"
        << "    done\n"
        << "    for ((i = 1; i < ${#words[@]}; i++)); do\n"
        << "        [[ ${words[i]} != --planner=* ]] || planner=${words[i]#*=}\n"
        << "    done\n"
        << "    if [[ $cur != *=* ]]; then\n"
        << "        compopt -o nospace\n"
        << "        case $planner in\n";
    const auto planners = planner_choices();
    for (const PlannerChoice& planner : planners) {
        std::vector<std::string> keys;
        for (const SettingChoice& setting : planner.settings) keys.push_back(setting.name + "=");
        out << "            " << planner.name << ") " << offer(joined(keys, " ")) << " ;;\n";
    }
    out << "        esac\n"
        << "        return\n"
        << "    fi\n"
        << "    local key=${cur%%=*}\n"
        << "    cur=${cur#*=}\n"
        << "    case $planner:$key in\n";
    for (const PlannerChoice& planner : planners)
        for (const SettingChoice& setting : planner.settings)
            if (!setting.words.empty())
                out << "        " << planner.name << ':' << setting.name << ") "
                    << offer(joined(setting.words, " ")) << " ;;\n";
    out << "    esac\n"
        << "    # Where '=' ends no word, what is offered replaces the key as well.\n"
        << "    [[ $COMP_WORDBREAKS == *=* ]] || COMPREPLY=(\"${COMPREPLY[@]/#/$key=}\")\n"
        << "}\n\n";
}

/// One branch for each option that takes a value; prefix: "maze:" for those of a family.
void write_values(std::ostream& out, const Command& command, const std::string& function,
                  const std::string& prefix) {
    for (const Argument& option : command.options) {
        if (option.value.kind == Value::Kind::none) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : option.names) patterns.push_back(prefix + name);
        out << "        " << joined(patterns, " | ") << ")\n            "
            << action(option.value, function) << "\n            return\n            ;;\n";
    }
}

std::string names_of(const Command& command) {
    std::vector<std::string> names;
    for (const Argument& option : command.options)
        names.insert(names.end(), option.names.begin(), option.names.end());
    return joined(names, " ");
}

/// Finds the family that stands in the line and completes the values of its options.
void write_families(std::ostream& out, const Command& command, const std::string& function) {
    std::vector<std::string> families;
    for (const Command& family : command.subcommands) families.push_back(family.name);
    out << "    local family= i\n"
        << "    for ((i = 1; i < cword; i++)); do\n"
        << "        case ${words[i]} in " << joined(families, " | ")
        << ") family=${words[i]} ;; esac\n"
        << "    done\n"
        << "    case $family:$prev in\n";
    for (const Command& family : command.subcommands)
        write_values(out, family, function, family.name + ":");
    out << "    esac\n";
}

/// What stands where no value of an option is due: options and positional arguments.
void write_words(std::ostream& out, const Command& command, const std::string& function) {
    out << "    if [[ $cur == -* ]]; then\n"
        << "        local options=" << quoted(names_of(command)) << '\n';
    if (!command.subcommands.empty()) {
        out << "        case $family in\n";
        for (const Command& family : command.subcommands)
            out << "            " << family.name
                << ") options+=" << quoted(glued({" ", names_of(family)})) << " ;;\n";
        out << "        esac\n";
    }
    out << "        mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$cur\")\n"
        << "        return\n"
        << "    fi\n";
    std::vector<std::string> families;
    for (const Command& family : command.subcommands) families.push_back(family.name);
    if (!families.empty())
        out << "    [[ -n $family ]] || " << offer(joined(families, " ")) << '\n';
    if (!command.positionals.empty())
        out << "    " << action(command.positionals.front().value, function) << '\n';
}

}  // namespace

std::string bash_completion(const Command& command) {
    const std::string function = function_prefix(command.name);
    std::ostringstream out;
    out << "# Made from the options of " << command.name << ", as --help prints them.\n"
        << "# shellcheck shell=bash disable=SC2154\n\n";
    if (takes(command, Value::Kind::setting)) write_settings(out, function);
    out << function << "()\n{\n"
        << "    local cur prev words cword split\n"
        << "    _init_completion -s || return\n"
        << "    case $prev in\n";
    write_values(out, command, function, "");
    out << "    esac\n";
    if (!command.subcommands.empty()) write_families(out, command, function);
    out << "    # An option that takes no value has got one.\n"
        << "    $split && return\n";
    write_words(out, command, function);
    out << "} &&\n    complete -F " << function << ' ' << command.name << '\n';
    return out.str();
}

}  // namespace asv::tools::manual
