#include "tools/common/number_options.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "io/text/number_text.hpp"

namespace asv::tools {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

/// All of the text as a number; none when it is not one, or beyond what the type holds.
template <class Value>
std::optional<Value> parsed(const std::string& text) {
    Value value{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end || text.empty()) return std::nullopt;
    return value;
}

std::string shown(double value) {
    std::string text;
    io::append_number(text, value);
    return text;
}

std::string refusal(const std::string& text, const std::string& wanted) {
    return "'" + text + "' is not " + wanted;
}

CLI::Validator number(double low, double high, const std::string& range,
                      const std::string& in_help) {
    return {[=](std::string& text) -> std::string {
                const auto value = parsed<double>(text);
                const bool good = value && std::isfinite(*value) && *value >= low && *value <= high;
                return good ? std::string() : refusal(text, "a decimal number" + range);
            },
            in_help};
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
    const std::string range = std::to_string(low) + " to " + std::to_string(high);
    return {[=](std::string& text) -> std::string {
                const auto value = parsed<std::uint64_t>(text);
                if (!value || *value < low || *value > high)
                    return refusal(text, "a whole decimal number from " + range);
                // Without leading zeros, which would make it octal.
                text = std::to_string(*value);
                return {};
            },
            range};
}

CLI::Validator number_between(double low, double high) {
    const std::string range = shown(low) + " to " + shown(high);
    return number(low, high, " from " + range, range);
}

CLI::Validator number_from(double low) {
    return number(low, largest, " of at least " + shown(low), ">=" + shown(low));
}

CLI::Validator finite_number() {
    return number(-largest, largest, "", "");
}

}  // namespace asv::tools
