#include "core/search/setting.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace asv::core {

namespace {

std::optional<double> word_of(const SettingValue& value, std::string_view text) {
    const auto found = std::find(value.words.begin(), value.words.end(), text);
    if (found == value.words.end()) return std::nullopt;
    return static_cast<double>(found - value.words.begin());
}

std::optional<double> number_of(std::string_view text) {
    double given = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), given);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return given;
}

/// The number that the text stands for, if it is one that the setting may be.
std::optional<double> parsed(const SettingValue& value, std::string_view text) {
    if (!value.words.empty()) return word_of(value, text);
    if (value.is_switch()) {
        if (text == "on" || text == "true") return 1;
        if (text == "off" || text == "false") return 0;
    }
    const auto given = number_of(text);
    if (!given || !(*given >= value.low && *given <= value.high)) return std::nullopt;
    if (value.whole && *given != std::floor(*given)) return std::nullopt;
    return given;
}

}  // namespace

SettingValue number(double& field, double low, double high, std::string unit) {
    return {.low = low,
            .high = high,
            .unit = std::move(unit),
            .get = [&field] { return field; },
            .set = [&field](double given) { field = given; }};
}

SettingValue number(std::size_t& field, double low, double high) {
    return {.low = low,
            .high = high,
            .whole = true,
            .get = [&field] { return static_cast<double>(field); },
            .set = [&field](double given) { field = static_cast<std::size_t>(given); }};
}

SettingValue on_or_off(bool& field) {
    return {.low = 0,
            .high = 1,
            .whole = true,
            .get = [&field] { return field ? 1.0 : 0.0; },
            .set = [&field](double given) { field = given != 0; }};
}

std::vector<Setting> joined(std::vector<std::vector<Setting>> parts) {
    std::vector<Setting> all;
    for (std::vector<Setting>& part : parts)
        all.insert(all.end(), std::make_move_iterator(part.begin()),
                   std::make_move_iterator(part.end()));
    return all;
}

std::string describe_range(const Setting& setting) {
    const SettingValue& value = setting.value;
    std::ostringstream text;
    if (!value.words.empty()) {
        for (const std::string& word : value.words)
            text << (&word == &value.words.front() ? "one of " : ", ") << word;
        return text.str();
    }
    if (value.is_switch())
        text << "on or off";
    else
        text << (value.whole ? "a whole number" : "a number") << " from " << value.low << " to "
             << value.high;
    if (!value.unit.empty()) text << ", " << value.unit;
    return text.str();
}

std::string describe_value(const Setting& setting) {
    const double value = setting.value.get();
    if (!setting.value.words.empty()) return setting.value.words[static_cast<std::size_t>(value)];
    if (setting.value.is_switch()) return value != 0 ? "on" : "off";
    std::ostringstream text;
    text << value;
    return text.str();
}

void assign(const Setting& setting, std::string_view text) {
    const auto value = parsed(setting.value, text);
    if (!value)
        throw std::invalid_argument("setting " + setting.name + " wants " +
                                    describe_range(setting) + ", not '" + std::string(text) + "'");
    setting.value.set(*value);
}

}  // namespace asv::core
