#pragma once

#include <string>
#include <vector>

/// The catalogue of planners as completions offer it.

namespace asv::tools::manual {

/// A setting's name and the words that it may be, none for a number.
struct SettingChoice {
    std::string name;
    std::string meaning;
    std::vector<std::string> words;
};

struct PlannerChoice {
    std::string name;
    std::string summary;
    std::vector<SettingChoice> settings;
};

/// All planners, the default first.
std::vector<PlannerChoice> planner_choices();

}  // namespace asv::tools::manual
