#include "core/validation/trajectory/validate_trajectory.hpp"
#include "io/solution/trajectory_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

void trajectory(std::string_view input) {
    constexpr std::size_t vehicles = 2;
    try {
        const core::Trajectory read = io::parse_trajectory(input, vehicles, "input").trajectory;
        require(read.states.size() == read.times.size() && !read.times.empty(),
                "a trajectory has as many states as times");
        const auto report = core::validate_trajectory(core::BodyKind::chain, read.states, read,
                                                      {{1}, {1}}, {.tolerance = 0});
        require(report.checks[1].ok(), "a trajectory keeps to the path of its own states");
        // What is written has increasing times.
        if (!report.checks[0].ok()) return;
        for (const auto format : {io::TrajectoryFormat::csv, io::TrajectoryFormat::json}) {
            const core::Trajectory again =
                io::parse_trajectory(io::format_trajectory(read, format), vehicles, "written")
                    .trajectory;
            require(again.times == read.times && again.states == read.states,
                    "a trajectory that was written reads back to the same numbers");
        }
    } catch (const io::ParseError& error) {
        require_place_in(input, error);
    }
}

}  // namespace asv::fuzz
