#include "tools/manual/command.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

/// "UINT:>=0" and "FLOAT" say too much and too little.
std::string shown_number(const std::string& type) {
    if (type.starts_with("UINT") || type.starts_with("INT")) return "N";
    if (type.starts_with("FLOAT")) return "NUMBER";
    return type.substr(0, type.find(':'));
}

Value value_of(const CLI::Option& option) {
    using Kind = Value::Kind;
    if (option.get_items_expected_max() == 0) return {};
    const std::string type = option.get_type_name();
    const std::size_t brace = type.find('{');
    if (type.starts_with("FILE")) return {Kind::file, "FILE", split(type.substr(4), '|')};
    if (type.starts_with("FOLDER")) return {Kind::folder, "FOLDER", {}};
    if (type.starts_with("PLANNER")) {
        std::vector<std::string> more = split(type, '|');
        more.erase(more.begin());
        return {Kind::planner, "PLANNER", more};
    }
    if (type.starts_with("KEY=VALUE")) return {Kind::setting, "KEY=VALUE", {}};
    if (brace != std::string::npos) {
        const std::size_t end = type.find('}', brace);
        const auto words = split(type.substr(brace + 1, end - brace - 1), ',');
        return {Kind::words, joined(words, "|"), words};
    }
    return {Kind::other, shown_number(type), {}};
}

Argument argument_of(const CLI::Option& option) {
    Argument argument;
    for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
    if (argument.names.empty()) argument.names.push_back(option.get_name());
    argument.description = option.get_description();
    argument.default_value = option.get_default_str();
    // CLI11 shows lists in brackets.
    if (argument.default_value.starts_with('['))
        argument.default_value =
            argument.default_value.substr(1, argument.default_value.size() - 2);
    argument.value = value_of(option);
    argument.required = option.get_required();
    argument.repeatable = option.get_expected_max() > 1;
    return argument;
}

}  // namespace

Command describe(const CLI::App& app) {
    Command command{app.get_name(), app.get_description(), {}, {}, {}, app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        (option->get_positional() ? command.positionals : command.options)
            .push_back(argument_of(*option));
    }
    for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
        command.subcommands.push_back(describe(*subcommand));
    return command;
}

bool takes(const Command& command, Value::Kind kind) {
    return std::ranges::any_of(
        command.options, [kind](const Argument& argument) { return argument.value.kind == kind; });
}

}  // namespace asv::tools::manual
