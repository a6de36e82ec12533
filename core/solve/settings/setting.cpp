#include "core/solve/settings/setting.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace asv::core {

namespace {

std::optional<double> word_of(const Setting& setting, std::string_view text) {
    const auto found = std::find(setting.words.begin(), setting.words.end(), text);
    if (found == setting.words.end()) return std::nullopt;
    return static_cast<double>(found - setting.words.begin());
}

std::optional<double> number_of(std::string_view text) {
    double given = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), given);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return given;
}

std::optional<double> value_of(const Setting& setting, std::string_view text) {
    if (!setting.words.empty()) return word_of(setting, text);
    if (setting.is_switch()) {
        if (text == "on" || text == "true") return 1;
        if (text == "off" || text == "false") return 0;
    }
    const auto given = number_of(text);
    if (!given || !(*given >= setting.low && *given <= setting.high)) return std::nullopt;
    if (setting.whole && *given != std::floor(*given)) return std::nullopt;
    return given;
}

}  // namespace

std::string describe_range(const Setting& setting) {
    std::ostringstream text;
    if (!setting.words.empty()) {
        for (const std::string& word : setting.words)
            text << (&word == &setting.words.front() ? "one of " : ", ") << word;
        return text.str();
    }
    if (setting.is_switch())
        text << "on or off";
    else
        text << (setting.whole ? "a whole number" : "a number") << " from " << setting.low << " to "
             << setting.high;
    if (!setting.unit.empty()) text << ", " << setting.unit;
    return text.str();
}

std::string describe_value(const Setting& setting) {
    const double value = setting.get();
    if (!setting.words.empty()) return setting.words[static_cast<std::size_t>(value)];
    if (setting.is_switch()) return value != 0 ? "on" : "off";
    std::ostringstream text;
    text << value;
    return text.str();
}

void assign(const Setting& setting, std::string_view text) {
    const auto value = value_of(setting, text);
    if (!value)
        throw std::invalid_argument("setting " + setting.name + " wants " +
                                    describe_range(setting) + ", not '" + std::string(text) + "'");
    setting.set(*value);
}

}  // namespace asv::core
