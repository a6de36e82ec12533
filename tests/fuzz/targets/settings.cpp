#include <stdexcept>
#include <string>

#include "core/solve/idle_settings.hpp"
#include "core/solve/planner_catalogue.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

constexpr core::BodyKind bodies[] = {core::BodyKind::chain, core::BodyKind::arm,
                                     core::BodyKind::point};

/// The text up to the next end of a line, which is taken off.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

void set_one(core::Planner& planner, std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view name = line.substr(0, equals);
    try {
        core::set(planner, name, line.substr(equals + 1));
    } catch (const std::invalid_argument&) {
        return;
    }
    for (const core::BodyKind body : bodies) core::why_without_effect(planner, name, body);
}

/// Every setting has a value that it may have, and the same again when it is set to its own words.
void require_sound(core::Planner& planner) {
    for (const core::Setting& setting : core::settings(planner)) {
        const double value = setting.value.get();
        require(setting.value.low <= value && value <= setting.value.high,
                "a setting is in its range");
        require(!core::describe_range(setting).empty(), "a setting tells its range");
        const std::string words = core::describe_value(setting);
        if (!setting.value.words.empty() || setting.value.is_switch()) {
            core::assign(setting, words);
            require(setting.value.get() == value, "a setting understands its own words");
        }
    }
}

}  // namespace

void settings(std::string_view input) {
    core::Planner planner;
    try {
        planner = core::planner_named(take_line(input));
    } catch (const std::invalid_argument&) {
        return;
    }
    while (!input.empty()) set_one(planner, take_line(input));
    require_sound(planner);
    for (const core::BodyKind body : bodies) {
        try {
            core::require_usable(planner, body);
        } catch (const std::invalid_argument&) {
            // Settings that contradict each other, or the body.
        }
    }
}

}  // namespace asv::fuzz
