#include <sstream>

#include "tools/manual/command.hpp"
#include "tools/manual/manual.hpp"
#include "tools/manual/planners.hpp"
#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

namespace {

/// Text between colons or brackets of a specification for _arguments or _describe.
std::string escaped(std::string text) {
    for (const char* special : {"\\", ":", "[", "]"})
        text = replaced(text, special, std::string("\\") + special);
    return text;
}

/// What a specification for _arguments says behind the second colon of a value.
std::string action(const Value& value, const std::string& function) {
    switch (value.kind) {
        case Value::Kind::file:
            if (value.words.empty()) return "_files";
            return "_files -g \"*.(" + joined(without_dots(value.words), "|") + ")(-.)\"";
        case Value::Kind::folder:
            return "_files -/";
        case Value::Kind::words:
            return glued({"(", joined(value.words, " "), ")"});
        case Value::Kind::planner: {
            std::string choices;
            for (const std::string& word : value.words) choices += word + "\\:every ";
            for (const PlannerChoice& planner : planner_choices())
                choices += planner.name + "\\:" + quoted(escaped(planner.summary)) + " ";
            return "((" + choices + "))";
        }
        case Value::Kind::setting:
            return function + "_settings";
        case Value::Kind::none:
        case Value::Kind::other:
            break;
    }
    return " ";
}

/// The specifications of one option, one for each of its names.
void write_option(std::ostream& out, const Argument& option, const std::string& function) {
    const bool valued = option.value.kind != Value::Kind::none;
    for (const std::string& name : option.names) {
        std::string spec = option.repeatable ? "*" : glued({"(", joined(option.names, " "), ")"});
        spec += name;
        if (valued) spec += name.starts_with("--") ? "=" : "+";
        spec += glued({"[", escaped(option.description), "]"});
        if (valued)
            spec += glued({":", escaped(option.value.shown), ":", action(option.value, function)});
        out << "        " << quoted(spec) << '\n';
    }
}

void write_positionals(std::ostream& out, const Command& command, const std::string& function) {
    int place = 0;
    for (const Argument& argument : command.positionals) {
        const std::string where = argument.repeatable ? "*" : std::to_string(++place);
        const std::string optional = argument.required || argument.repeatable ? ":" : "::";
        out << "        "
            << quoted(where + optional + argument.names.front() + ":" +
                      action(argument.value, function))
            << '\n';
    }
}

/// "--set KEY=VALUE": first the keys of the planner that stands in the line, then the words of one.
void write_settings(std::ostream& out, const std::string& function) {
    const auto planners = planner_choices();
    out << function << "_settings() {\n"
        << "    local planner=auto key=${PREFIX%%=*}\n"
        << "    local -i i\n"
        << "    for (( i = 2; i <= $#words; ++i )); do\n"
        << "        case $words[i] in\n"
        << "            --planner) planner=$words[i+1] ;;\n"
        << "            --planner=*) planner=${words[i]#*=} ;;\n"
        << "        esac\n"
        << "    done\n"
        << "    local -a settings\n"
        << "    if compset -P '*='; then\n"
        << "        case $planner:$key in\n";
    for (const PlannerChoice& planner : planners)
        for (const SettingChoice& setting : planner.settings)
            if (!setting.words.empty())
                out << "            " << planner.name << ':' << setting.name << ") compadd -- "
                    << joined(setting.words, " ") << " ;;\n";
    out << "        esac\n"
        << "        return\n"
        << "    fi\n"
        << "    case $planner in\n";
    for (const PlannerChoice& planner : planners) {
        out << "        " << planner.name << ") settings=(\n";
        for (const SettingChoice& setting : planner.settings)
            out << "            " << quoted(setting.name + ":" + escaped(setting.meaning)) << '\n';
        out << "        ) ;;\n";
    }
    out << "    esac\n"
        << "    _describe setting settings -S =\n"
        << "}\n\n";
}

/// The options of the family that stands in the line come to those of all.
void write_families(std::ostream& out, const Command& command, const std::string& function) {
    out << "    local word family\n"
        << "    for word in $words[2,CURRENT-1]; do\n"
        << "        case $word in\n";
    for (const Command& family : command.subcommands)
        out << "            " << family.name << ") family=$word ;;\n";
    out << "        esac\n"
        << "    done\n"
        << "    case $family in\n";
    for (const Command& family : command.subcommands) {
        out << "        " << family.name << ") arguments+=(\n";
        for (const Argument& option : family.options)
            if (option.names.back() != "--help") write_option(out, option, function);
        out << "        ) ;;\n";
    }
    out << "    esac\n";
    std::string families;
    for (const Command& family : command.subcommands)
        families += family.name + "\\:" + quoted(escaped(family.description)) + " ";
    out << "    arguments+=(" << quoted("1:family:((" + families + "))") << ")\n";
}

}  // namespace

std::string zsh_completion(const Command& command) {
    const std::string function = function_prefix(command.name);
    std::ostringstream out;
    out << "#compdef " << command.name << "\n\n"
        << "# Made from the options of " << command.name << ", as --help prints them.\n\n";
    if (takes(command, Value::Kind::setting)) write_settings(out, function);
    out << function << "() {\n"
        << "    local -a arguments\n"
        << "    arguments=(\n";
    for (const Argument& option : command.options) write_option(out, option, function);
    write_positionals(out, command, function);
    out << "    )\n";
    if (!command.subcommands.empty()) write_families(out, command, function);
    out << "    _arguments -s $arguments\n"
        << "}\n\n"
        << function << " \"$@\"\n";
    return out.str();
}

}  // namespace asv::tools::manual
