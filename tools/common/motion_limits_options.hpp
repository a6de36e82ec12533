#pragma once

#include <CLI/CLI.hpp>

#include "core/model/problem.hpp"

namespace asv::tools {

/// Adds --speed and --acceleration, which mean nothing without the option that is given.
void add_motion_limits(CLI::App& app, core::MotionLimits& limits, CLI::Option* trajectory);

/// The limits of the options and, where one says nothing, of the problem. Throws UsageError where
/// neither knows a limit, or where an option has neither one number nor one for each vehicle.
core::MotionLimits motion_limits(const core::MotionLimits& options, const core::Problem& problem);

}  // namespace asv::tools
