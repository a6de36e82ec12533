#pragma once

#include "core/solve/planner_catalogue.hpp"

namespace asv::python {

/// A planner and its settings, as Python holds them. (A variant itself pybind11 would take apart.)
struct PlannerChoice {
    core::Planner planner;
};

}  // namespace asv::python
