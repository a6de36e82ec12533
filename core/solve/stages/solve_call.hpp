#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "core/model/problem.hpp"
#include "core/solve/bodies/body_solver.hpp"
#include "core/solve/planning_frame.hpp"
#include "core/solve/solve.hpp"
#include "core/solve/stages/solve_clock.hpp"

namespace asv::core {

/// What the stages of one call of solve() share: what was asked for, its clock, and the problem as
/// it is planned. Refers to all of it.
struct SolveCall {
    const Problem& problem;  ///< as it was given
    const SolveOptions& options;
    const SolveClock& clock;
    const PlanningFrame& frame;
    const BodySolver& solver;  ///< of the frame's problem
    /// Seconds of processor time to keep for checking and writing a path.
    double time_to_finish;

    /// When a search or an improvement that begins now has to end, so that what it finds can still
    /// be checked and written. On a busy machine that takes longer, and a disk may keep a file
    /// waiting: some of a long limit is kept in any case, and of a short one half at most. Asked in
    /// the thread of the call.
    Clock::time_point deadline() const {
        constexpr double share = 0.03, longest_share = 0.3;  // of the limit; seconds
        const double reserve = std::max(time_to_finish * clock.slowdown(),
                                        std::min(share * clock.time_limit(), longest_share));
        return clock.moment_before_end(std::min(reserve, 0.5 * clock.time_limit()));
    }

    /// As many as were asked for, but so many for each processor at most: more only wait for each
    /// other, when a path is found as much as when the time is up.
    std::size_t threads() const {
        constexpr std::size_t for_each_processor = 8;
        const std::size_t most =
            for_each_processor * std::max(1U, std::thread::hardware_concurrency());
        return std::clamp<std::size_t>(options.threads, 1, most);
    }

    /// The number of a thread among all that race, other processes' too.
    std::size_t racer(std::size_t thread) const { return options.first_racer + thread; }

    /// A seed for each thread, that of the options for the first racer.
    std::uint64_t seed(std::size_t thread) const {
        constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;
        return options.seed + golden_ratio * racer(thread);
    }
};

}  // namespace asv::core
