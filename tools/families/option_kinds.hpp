#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tools/common/command_line.hpp"
#include "tools/common/number_options.hpp"

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

/// The least and the greatest that an option may be.
struct Range {
    double low = 0, high = 0;
};

/// Adds an option that takes a decimal number, std::optional where it may be left open.
template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& value, Range range,
                        const std::string& description) {
    CLI::Option* option =
        app.add_option(name, value, description)->transform(number_between(range.low, range.high));
    if constexpr (std::is_arithmetic_v<Number>) option->capture_default_str();
    return option;
}

/// Adds one that takes a whole decimal number.
template <class Count>
CLI::Option* add_count(CLI::App& app, const std::string& name, Count& value, Range range,
                       const std::string& description) {
    CLI::Option* option = app.add_option(name, value, description)
                              ->transform(whole_number(static_cast<std::uint64_t>(range.low),
                                                       static_cast<std::uint64_t>(range.high)));
    if constexpr (std::is_arithmetic_v<Count>) option->capture_default_str();
    return option;
}

}  // namespace asv::tools
