#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace asv::core {

/// One value of a planner that can be set by its name: a number, a switch (0 or 1), or one of
/// several words (the index of the word).
struct Setting {
    std::string name;
    std::string meaning;
    std::string unit;  ///< empty for a plain number
    double low = 0, high = 0;
    bool whole = false;  ///< only whole numbers
    std::function<double()> get;
    std::function<void(double)> set;
    std::vector<std::string> words = {};  ///< one for each whole number from 0 to high

    /// On or off.
    bool is_switch() const { return words.empty() && whole && low == 0 && high == 1; }
};

/// What a setting may be: "a number from 0 to 1, workspace units".
std::string describe_range(const Setting& setting);

/// Its value now, as it is set: "0.05", "on", "uniform".
std::string describe_value(const Setting& setting);

/// Sets it from text. Throws std::invalid_argument, which says what it may be, for anything else.
void assign(const Setting& setting, std::string_view text);

/// A setting that is a number, kept in `value`, which has to outlive it.
template <class Number>
Setting number(std::string name, Number& value, double low, double high, std::string unit,
               std::string meaning) {
    return {std::move(name),
            std::move(meaning),
            std::move(unit),
            low,
            high,
            !std::is_floating_point_v<Number>,
            [&value] { return static_cast<double>(value); },
            [&value](double given) { value = static_cast<Number>(given); }};
}

/// A setting that is on or off.
inline Setting flag(std::string name, bool& value, std::string meaning) {
    return number(std::move(name), value, 0, 1, "", std::move(meaning));
}

/// A setting that is one of some words, which stand for the enumerators in their order.
template <class Enum>
Setting choice(std::string name, Enum& value, std::vector<std::string> words, std::string meaning) {
    const auto high = static_cast<double>(words.size() - 1);
    return {std::move(name),
            std::move(meaning),
            "",
            0,
            high,
            true,
            [&value] { return static_cast<double>(value); },
            [&value](double given) { value = static_cast<Enum>(static_cast<int>(given)); },
            std::move(words)};
}

}  // namespace asv::core
