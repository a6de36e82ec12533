#pragma once

#include <string>
#include <string_view>

#include "core/solve/planner_catalogue.hpp"

namespace asv::core {

/// Why the setting, which the planner has, changes nothing for such a body and with the other
/// settings as they are: "an arm does not slide", "swap-limiter is off". Empty where it counts, as
/// far as that can be told beforehand.
std::string why_without_effect(const Planner& planner, std::string_view setting, BodyKind body);

}  // namespace asv::core
