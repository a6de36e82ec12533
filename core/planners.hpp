#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "asv/core/planning/rrt_connect.hpp"
#include "asv/core/planning/slide_pull.hpp"
#include "asv/core/space/classic_space.hpp"
#include "asv/core/space/steering/slide.hpp"

/// The planners by name, and their settings by name: what a command line can choose from.

namespace asv::core {

/// `auto`: slides and pulls between two trees.
struct AutoPlanner {
    SlideOptions steering;
    SlidePullOptions search;
};

/// `rrt-connect`: the bidirectional RRT for ASVs with corridor sampling, angle enlargement and
/// ladder moves.
struct RrtConnectPlanner {
    ClassicOptions space;
    RrtConnectOptions search;
};

using Planner = std::variant<AutoPlanner, RrtConnectPlanner>;

/// The names that planner_named() knows, the default first.
std::vector<std::string_view> planner_names();

/// What one line of documentation says of a planner.
std::string_view planner_summary(std::string_view name);

/// The planner with its default settings. Throws std::invalid_argument for an unknown name.
Planner planner_named(std::string_view name);

/// Name of the planner that is chosen.
std::string_view name(const Planner& planner);

/// One number of a planner that can be set by its name. A switch is 0 or 1.
struct Setting {
    std::string name;
    std::string meaning;
    std::string unit;  ///< empty for a plain number
    double low = 0, high = 0;
    bool whole = false;  ///< only whole numbers
    std::function<double()> get;
    std::function<void(double)> set;
};

/// What a setting may be: "a number from 0 to 1, workspace units".
std::string describe_range(const Setting& setting);

/// The settings of the planner, which has to outlive them.
std::vector<Setting> settings(Planner& planner);

/// Sets one setting. Throws std::invalid_argument, which says what there is, for an unknown name or
/// a value that is out of range.
void set(Planner& planner, std::string_view setting, std::string_view value);

/// Throws std::invalid_argument when the settings contradict each other.
void require_usable(const Planner& planner);

}  // namespace asv::core
