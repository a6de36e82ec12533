#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// How an option says of itself what it is. Each struct of options is followed by a function
/// settings_of(options), which declares its fields: the only place that tells their names on a
/// command line, meanings, units, ranges, reasons and sources. `--set`, `--list-planners` and
/// docs/settings.md are made from it.
///
/// The declarations stand in the headers, below the fields, since there everyone looks who sets an
/// option; they are plain functions without templates, so that including them costs little.

namespace asv::core {

/// What a setting holds, as a number: a number itself, a switch (0 or 1), or one of several words
/// (the index of the word); and which numbers it may be.
struct SettingValue {
    double low = 0, high = 0;             ///< the range, both ends included
    std::string unit = {};                ///< empty for counts, shares, switches and words
    bool whole = false;                   ///< only whole numbers
    std::vector<std::string> words = {};  ///< one for each whole number from 0 to high
    std::function<double()> get;
    std::function<void(double)> set;

    /// On or off.
    bool is_switch() const { return words.empty() && whole && low == 0 && high == 1; }
};

/// One option that can be set by its name. Its default is the value of a new struct of options.
struct Setting {
    std::string name;
    std::string meaning;
    SettingValue value;
    std::string why = {};     ///< why the default is what it is
    std::string source = {};  ///< who proposed what it sets, or "own"
};

/// Units of lengths: how far the body moves as the metric of its space has it, and lengths in the
/// plane.
inline constexpr const char* in_metric = "in the metric";
inline constexpr const char* workspace_units = "workspace units";

/// A setting that is a number, kept in the field, which has to outlive it.
SettingValue number(double& field, double low, double high, std::string unit = {});

/// One that is a whole number.
SettingValue number(std::size_t& field, double low, double high);

/// One that is on or off.
SettingValue on_or_off(bool& field);

/// One that is one of some words, which stand for the enumerators in their order.
template <class Enum>
SettingValue one_of(Enum& field, std::vector<std::string> words) {
    SettingValue value;
    value.high = static_cast<double>(words.size() - 1);
    value.whole = true;
    value.words = std::move(words);
    value.get = [&field] { return static_cast<double>(field); };
    value.set = [&field](double given) { field = static_cast<Enum>(static_cast<int>(given)); };
    return value;
}

/// The settings of several structs of options, one after the other.
std::vector<Setting> joined(std::vector<std::vector<Setting>> parts);

/// What a setting may be: "a number from 0 to 1, workspace units".
std::string describe_range(const Setting& setting);

/// Its value now, as it is set: "0.05", "on", "uniform".
std::string describe_value(const Setting& setting);

/// Sets it from text. Throws std::invalid_argument, which says what it may be, for anything else.
void assign(const Setting& setting, std::string_view text);

}  // namespace asv::core
