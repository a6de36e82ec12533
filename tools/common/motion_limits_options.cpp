#include "tools/common/motion_limits_options.hpp"

#include <string>

#include "tools/common/command_line.hpp"
#include "tools/common/number_options.hpp"

namespace asv::tools {

namespace {

void add_limit(CLI::App& app, const std::string& name, std::vector<double>& limits,
               const std::string& description, CLI::Option* trajectory) {
    app.add_option(name, limits,
                   description +
                       ": one number for all vehicles, or one for each, with commas; "
                       "default: that of the scenario")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->transform(number_between(core::least_motion_limit, core::greatest_motion_limit))
        ->type_name("N,...")
        ->needs(trajectory);
}

const std::vector<double>& chosen(const std::vector<double>& option,
                                  const std::vector<double>& scenario, const std::string& name,
                                  std::size_t vehicles) {
    if (option.empty() && scenario.empty())
        throw UsageError("--trajectory needs the " + name + " limit of the vehicles: by --" + name +
                         ", or by \"limits\": {\"" + name + "\": ...} in a scenario");
    if (option.size() > 1 && option.size() != vehicles)
        throw UsageError("--" + name + " has " + std::to_string(option.size()) +
                         " numbers; it takes one for all vehicles or one for each of " +
                         std::to_string(vehicles));
    return option.empty() ? scenario : option;
}

}  // namespace

void add_motion_limits(CLI::App& app, core::MotionLimits& limits, CLI::Option* trajectory) {
    add_limit(app, "--speed", limits.speed, "Greatest speed, workspace units per second",
              trajectory);
    add_limit(app, "--acceleration", limits.acceleration,
              "Greatest acceleration, workspace units per second squared", trajectory);
}

core::MotionLimits motion_limits(const core::MotionLimits& options, const core::Problem& problem) {
    const core::MotionLimits& known = problem.motion_limits;
    const std::size_t vehicles = problem.asv_count();
    return {chosen(options.speed, known.speed, "speed", vehicles),
            chosen(options.acceleration, known.acceleration, "acceleration", vehicles)};
}

}  // namespace asv::tools
