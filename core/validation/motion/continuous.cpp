#include "core/validation/motion/continuous.hpp"

#include <array>
#include <utility>

#include "core/validation/motion/motion_collisions.hpp"
#include "core/validation/motion/motion_shape.hpp"

namespace asv::core::validation {

std::vector<CheckResult> certify_motion(const Path& path, const Requirements& requirements,
                                        const Obstacles& obstacles, bool list_offenders) {
    std::array<Tally, 5> tallies = {
        Tally(Check::broom_lengths, list_offenders), Tally(Check::convexity, list_offenders),
        Tally(Check::area, list_offenders), Tally(Check::bounds, list_offenders),
        Tally(Check::collisions, list_offenders)};
    auto& [broom_lengths, convexity, area, bounds, collisions] = tallies;
    Motion motion(path.asv_count());
    for (std::size_t step = 1; step < path.size(); ++step) {
        const State from = path.state(step - 1);
        const State to = path.state(step);
        if (const std::optional<Finding> bad = find_not_finite(from, to)) {
            for (Tally& tally : tallies) tally.add(*bad, step);
            continue;
        }
        for (std::size_t i = 0; i < motion.size(); ++i) motion[i] = {from[i], to[i]};
        broom_lengths.add(check_motion_broom_lengths(motion, requirements), step);
        // Only what is tighter than all before is of interest, which saves measuring the rest.
        const auto least_room = [](const Tally& tally) { return tally.worst().offender.room; };
        convexity.add(check_motion_convexity(motion, requirements, least_room(convexity)), step);
        area.add(check_motion_area(motion, requirements), step);
        bounds.add(check_motion_bounds(from, to, requirements), step);
        collisions.add(check_motion_collisions(motion, obstacles, least_room(collisions)), step);
    }
    std::vector<CheckResult> results;
    for (Tally& tally : tallies) results.push_back(std::move(tally).result());
    return results;
}

}  // namespace asv::core::validation
