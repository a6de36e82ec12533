#include "io/problem/scenario_limits.hpp"

#include <string>

namespace asv::io {

namespace {

using Pointer = JsonDocument::Pointer;

std::vector<double> read_list(const JsonDocument& document, const Pointer& at,
                              std::size_t vehicles) {
    const auto limit = [&](const Pointer& place) {
        return document.number(place, core::least_motion_limit, core::greatest_motion_limit);
    };
    if (!document.has(at)) return {};
    if (document.is_number(at)) return {limit(at)};
    if (!document.is_array(at) || document.array(at).size() != vehicles)
        document.fail(at, "a number, or an array of one for each of " + std::to_string(vehicles) +
                              " vehicles");
    std::vector<double> limits;
    for (std::size_t i = 0; i < vehicles; ++i) limits.push_back(limit(at / i));
    return limits;
}

}  // namespace

core::MotionLimits read_motion_limits(const JsonDocument& document, const Pointer& at,
                                      std::size_t vehicles) {
    document.require_members(at, {}, {"speed", "acceleration"});
    return {read_list(document, at / "speed", vehicles),
            read_list(document, at / "acceleration", vehicles)};
}

}  // namespace asv::io
