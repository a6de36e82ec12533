#include "asv/core/planners.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace asv::core {

namespace {

struct Entry {
    std::string_view name;
    std::string_view summary;
    Planner planner;
};

const std::array<Entry, 2>& catalogue() {
    static const std::array<Entry, 2> entries{{
        {"auto", "two trees that slide along what they meet and pull the ends of the chain",
         AutoPlanner{}},
        {"rrt-connect",
         "bidirectional RRT for ASVs: stepwise and corridor sampling, angle enlargement, ladder",
         RrtConnectPlanner{}},
    }};
    return entries;
}

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

Setting flag(std::string name, bool& value, std::string meaning) {
    return number(std::move(name), value, 0, 1, "", std::move(meaning));
}

/// An order of growing the trees that can be taken out of the rotation.
Setting order(std::string name, std::vector<GrowthOrder>& orders, GrowthOrder which,
              std::string meaning) {
    return {std::move(name),
            std::move(meaning),
            "",
            0,
            1,
            true,
            [&orders, which] {
                return std::count(orders.begin(), orders.end(), which) > 0 ? 1.0 : 0.0;
            },
            [&orders, which](double on) {
                std::erase(orders, which);
                if (on != 0) orders.push_back(which);
            }};
}

std::vector<Setting> settings_of(AutoPlanner& planner) {
    SlideOptions& s = planner.steering;
    SlidePullOptions& p = planner.search;
    return {
        flag("slide", s.slide, "slide along what blocks a straight motion"),
        number("slide-step", s.step, 1e-4, 0.5, "workspace units",
               "longest constrained step, root mean square motion of the ASVs"),
        number("slide-margin", s.margin, 1e-6, 0.1, "workspace units",
               "gap kept to obstacles where there is room"),
        number("slide-hair", s.hair, 1e-7, 0.01, "workspace units",
               "least gap, where the place is tight"),
        number("slide-progress", s.progress, 0, 1, "",
               "share of its length by which a constrained step has to come nearer"),
        number("slide-steps", s.most_steps, 1, 1e6, "", "most constrained steps of one slide"),
        number("pull-share", p.pull_share, 0, 1, "", "share of the iterations that pull"),
        number("guide-share", p.guide_share, 0, 1, "",
               "share of the iterations that grow a tree along the shortest way of one ASV"),
        number("guide-patience", p.guide_patience, 0.01, 1e9, "",
               "such iterations in vain after which that share has halved"),
        number("passage-share", p.passage_share, 0, 1, "",
               "share of the pulls whose target lies in a passage (bridge test)"),
        number("pull-candidates", p.pull_candidates, 1, 1e4, "",
               "nodes of which the most promising one is pulled"),
    };
}

std::vector<Setting> settings_of(RrtConnectPlanner& planner) {
    ClassicOptions& c = planner.space;
    auto& orders = planner.search.orders;
    return {
        flag("stepwise", c.stepwise, "sample dimension by dimension from anywhere"),
        flag("corridor", c.corridor, "sample with ASV 1 in a gap between obstacles"),
        flag("corridor-reversed", c.corridor_reversed,
             "sample with the last ASV in a gap between obstacles"),
        number("widest-corridor", c.widest_corridor, 1e-3, 10, "workspace units",
               "gap between obstacles that counts as a corridor"),
        flag("limit-angles", c.limit_angles,
             "sample no turn sharper than the sharpest of start and goal"),
        number("lift-after", c.lift_after, 1, 1e6, "",
               "failed samples in a row that lift the limit of angles"),
        number("lifted-for", c.lifted_for, 1, 1e6, "", "samples for which it stays lifted"),
        number("heading-weight", c.heading_weight, 0, 100, "units/radian",
               "weight of the heading in the distance"),
        flag("enlarge", c.enlarge, "angle enlargement where an extension is blocked"),
        number("enlarge-tries", c.enlarge_tries, 1, 1000, "",
               "how often the angles open a little more"),
        number("enlarge-share", c.enlarge_share, 1e-4, 0.9, "",
               "share by which the turns shrink each time"),
        flag("ladder", c.ladder, "ladder moves where an extension is blocked"),
        number("step", c.step, 1e-5, 0.1, "workspace units",
               "resolution of an extension, largest motion of an ASV"),
        order("order-both", orders, GrowthOrder::both_to_sample, "grow both trees to the sample"),
        order("order-start", orders, GrowthOrder::start_then_goal,
              "grow the start tree to the sample, the goal tree to where that came"),
        order("order-goal", orders, GrowthOrder::goal_then_start,
              "grow the goal tree to the sample, the start tree to where that came"),
    };
}

[[noreturn]] void unknown_setting(Planner& planner, std::string_view given) {
    std::ostringstream text;
    text << "planner " << name(planner) << " has no setting '" << given << "'; there are:";
    for (const Setting& s : settings(planner))
        text << "\n  " << s.name << ": " << s.meaning << " (" << describe_range(s) << "; default "
             << s.get() << ")";
    throw std::invalid_argument(text.str());
}

}  // namespace

std::string describe_range(const Setting& setting) {
    std::ostringstream text;
    if (setting.whole && setting.low == 0 && setting.high == 1)
        text << "on or off";
    else
        text << (setting.whole ? "a whole number" : "a number") << " from " << setting.low << " to "
             << setting.high;
    if (!setting.unit.empty()) text << ", " << setting.unit;
    return text.str();
}

std::vector<std::string_view> planner_names() {
    std::vector<std::string_view> names;
    for (const Entry& entry : catalogue()) names.push_back(entry.name);
    return names;
}

std::string_view planner_summary(std::string_view name) {
    for (const Entry& entry : catalogue())
        if (entry.name == name) return entry.summary;
    return {};
}

Planner planner_named(std::string_view name) {
    std::string known;
    for (const Entry& entry : catalogue()) {
        if (entry.name == name) return entry.planner;
        known += (known.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw std::invalid_argument("there is no planner '" + std::string(name) +
                                "'; there are: " + known);
}

std::string_view name(const Planner& planner) {
    return catalogue()[planner.index()].name;
}

std::vector<Setting> settings(Planner& planner) {
    return std::visit([](auto& chosen) { return settings_of(chosen); }, planner);
}

void set(Planner& planner, std::string_view setting, std::string_view value) {
    for (const Setting& s : settings(planner)) {
        if (s.name != setting) continue;
        double given = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), given);
        if (value == "on" || value == "true") {
            given = 1;
        } else if (value == "off" || value == "false") {
            given = 0;
        } else if (error != std::errc{} || end != value.data() + value.size()) {
            given = std::nan("");
        }
        if (!(given >= s.low && given <= s.high) || (s.whole && given != std::floor(given)))
            throw std::invalid_argument("setting " + s.name + " wants " + describe_range(s) +
                                        ", not '" + std::string(value) + "'");
        s.set(given);
        return;
    }
    unknown_setting(planner, setting);
}

void require_usable(const Planner& planner) {
    if (const auto* classic = std::get_if<RrtConnectPlanner>(&planner))
        if (classic->search.orders.empty())
            throw std::invalid_argument(
                "rrt-connect needs at least one order of growing its trees");
}

}  // namespace asv::core
