#include "core/benchmark/plan.hpp"

namespace asv::core {

std::string_view name(Direction direction) {
    return direction == Direction::forward ? "forward" : "reversed";
}

std::vector<RunPlace> places(const BenchmarkPlan& plan) {
    std::vector<RunPlace> result;
    result.reserve(run_count(plan));
    for (std::size_t problem = 0; problem < plan.problems.size(); ++problem)
        for (const Direction direction : plan.directions)
            for (std::size_t planner = 0; planner < plan.planners.size(); ++planner)
                for (std::size_t seed = 0; seed < plan.seeds; ++seed)
                    result.push_back({problem, planner, direction, plan.first_seed + seed});
    return result;
}

std::size_t run_count(const BenchmarkPlan& plan) {
    return plan.problems.size() * plan.directions.size() * plan.planners.size() * plan.seeds;
}

SolveOptions solve_options(const BenchmarkPlan& plan, const RunPlace& place) {
    SolveOptions options;
    options.planner = plan.planners[place.planner].planner;
    options.seed = place.seed;
    options.time_limit = plan.time_limit;
    options.optimize = plan.optimize;
    options.threads = plan.threads;
    options.reverse = place.direction == Direction::reversed;
    return options;
}

}  // namespace asv::core
