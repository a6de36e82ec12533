#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <ompl/base/Planner.h>

/// OMPL's planners by name.

namespace asv::adaptor {

/// The names that ompl_planner() knows, those of OMPL's classes, in alphabetical order.
std::vector<std::string_view> ompl_planner_names();

/// A planner with OMPL's default parameters. Throws std::invalid_argument, which says what there
/// is, for an unknown name.
ompl::base::PlannerPtr ompl_planner(std::string_view name,
                                    const ompl::base::SpaceInformationPtr& information);

/// Sets one of a planner's parameters. Throws std::invalid_argument, which says what there is, for
/// an unknown name or a value that OMPL does not take.
void set_parameter(ompl::base::Planner& planner, const std::string& name, const std::string& value);

/// Of the plane, for who only wants to see a planner's parameters.
ompl::base::SpaceInformationPtr information_of_a_plane();

}  // namespace asv::adaptor
