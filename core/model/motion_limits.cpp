#include "core/model/motion_limits.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace asv::core {

namespace {

void require_list(const std::vector<double>& limits, const std::string& name,
                  std::size_t vehicles) {
    if (limits.size() != 1 && limits.size() != vehicles)
        throw std::invalid_argument(name + " has " + std::to_string(limits.size()) +
                                    " numbers; it has one for all vehicles or one for each of " +
                                    std::to_string(vehicles));
    const auto usable = [](double limit) {
        return limit >= least_motion_limit && limit <= greatest_motion_limit;
    };
    if (!std::all_of(limits.begin(), limits.end(), usable))
        throw std::invalid_argument(name + " is a number from 1e-12 to 1e12");
}

}  // namespace

void require_usable(const MotionLimits& limits, std::size_t vehicles) {
    require_list(limits.speed, "speed", vehicles);
    require_list(limits.acceleration, "acceleration", vehicles);
}

}  // namespace asv::core
