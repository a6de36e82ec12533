#pragma once

#include <string>
#include <vector>

#include "core/solve/planner_catalogue.hpp"

/// The settings of each planner, which has to outlive them; one file for each kind of search.

namespace asv::core {

std::vector<Setting> settings_of(AutoPlanner& planner);
std::vector<Setting> settings_of(RrtConnectPlanner& planner);
std::vector<Setting> settings_of(RrtPlanner& planner);
std::vector<Setting> settings_of(RrtStarPlanner& planner);
std::vector<Setting> settings_of(PrmPlanner& planner);

/// Those of the sampler, which most planners have.
std::vector<Setting> settings_of(SamplerOptions& sampler);

/// What is common to settings that are lengths in the metric of the body's space.
inline const std::string metric_unit = "in the metric";

/// The settings of the one, then those of the other.
inline std::vector<Setting> joined(std::vector<Setting> first, std::vector<Setting> second) {
    for (Setting& setting : second) first.push_back(std::move(setting));
    return first;
}

}  // namespace asv::core
