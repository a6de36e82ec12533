#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/common/command_line.hpp"

namespace asv::tools {

/// Adds an option that takes one of some words; without it the first one counts.
template <class Value>
void add_choice(CLI::App& app, const std::string& name, Value& value,
                const std::string& description,
                const std::vector<std::pair<std::string, Value>>& choices) {
    std::string words;
    std::string listed;
    for (const auto& [word, meaning] : choices) {
        words += (words.empty() ? "" : "|") + word;
        listed += (listed.empty() ? "" : ",") + word;
    }
    app.add_option(name, value, description)
        ->type_name("{" + listed + "}")
        ->transform(CLI::CheckedTransformer(choices, CLI::ignore_case))
        ->default_str(choices.front().first)
        ->option_text(words + "=" + choices.front().first);
}

/// Adds an option that takes a whole number; a negative one would wrap round to a huge one.
template <class Count>
CLI::Option* add_count(CLI::App& app, const std::string& name, Count& value,
                       const std::string& description) {
    return app.add_option(name, value, description)
        ->check(finite_and_not_negative())
        ->capture_default_str();
}

}  // namespace asv::tools
