#include "core/solve/solve.hpp"
#include "io/problem/scenario_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

void require_sound_arm(const core::PlanarArm& arm) {
    const std::size_t links = arm.links.size();
    require(links >= 1 && arm.joints.size() == links && arm.start.size() == links &&
                arm.goal.size() == links,
            "an arm has as many ranges and angles as links");
    for (std::size_t i = 0; i < links; ++i) {
        require(arm.links[i] > 0, "links are positive");
        const core::JointRange& range = arm.joints[i];
        for (const double angle : {arm.start[i], arm.goal[i]})
            require(range.wraps || (range.low <= angle && angle <= range.high),
                    "start and goal are within the ranges");
    }
}

}  // namespace

void scenario(std::string_view input) {
    try {
        const core::Problem read =
            io::parse_scenario(input, "input", ASV_SOURCE_DIR "/testcases/bodies").problem;
        require_sound(read);
        if (read.arm() != nullptr) require_sound_arm(*read.arm());
        core::invalid_ends(read);
    } catch (const io::ParseError& error) {
        // Else it is the map that was not understood.
        if (error.file() == "input") require_place_in(input, error);
    } catch (const io::ReadError&) {
        // No map of that name is there.
    }
}

}  // namespace asv::fuzz
