#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/validate.hpp"

/// Chains and paths that are written down for tests of the validator.

namespace asv::test {

using geometry::Point;
using Chain = std::vector<Point>;

inline constexpr double right_angle = std::numbers::pi / 2;

/// Brooms of length 0.05 from `first` on, the first with the given heading, then turn by turn.
inline Chain chain_with_turns(Point first, double heading, std::span<const double> turns) {
    Chain chain = {first};
    for (std::size_t i = 0; i <= turns.size(); ++i) {
        if (i > 0) heading += turns[i - 1];
        const Point& last = chain.back();
        chain.push_back({last.x + 0.05 * std::cos(heading), last.y + 0.05 * std::sin(heading)});
    }
    return chain;
}

inline Chain chain_with_turns(Point first, double heading, std::initializer_list<double> turns) {
    return chain_with_turns(first, heading, std::span(turns.begin(), turns.size()));
}

/// Three ASVs, a right angle to the left at the second: (0.5, 0.5), (0.55, 0.5), (0.55, 0.55).
inline Chain corner() {
    return {{0.5, 0.5}, {0.55, 0.5}, {0.55, 0.55}};
}

inline Chain moved(Chain chain, double dx, double dy) {
    for (Point& point : chain) point = {point.x + dx, point.y + dy};
    return chain;
}

/// The chain goes right by `step` as often as asked; start, goal and cost agree with it.
struct Case {
    core::Problem problem;
    core::Solution solution{core::Path(1), 0};
};

inline double cost(const core::Path& path) {
    double total = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        for (std::size_t k = 0; k < path.asv_count(); ++k) {
            const Point& a = path.state(i - 1)[k];
            const Point& b = path.state(i)[k];
            total += std::hypot(b.x - a.x, b.y - a.y);
        }
    }
    return total;
}

/// A problem and a solution that consists of exactly these states.
inline Case case_of(const std::vector<Chain>& states) {
    Case result;
    result.problem.start = states.front();
    result.problem.goal = states.back();
    result.solution.path = core::Path(states.front().size());
    for (const Chain& state : states) result.solution.path.push_back(state);
    result.solution.cost = cost(result.solution.path);
    return result;
}

inline const core::CheckResult& find(const std::vector<core::CheckResult>& results,
                                     core::Check check) {
    for (const core::CheckResult& result : results) {
        if (result.check == check) return result;
    }
    throw std::out_of_range("no such check");
}

/// The checks that failed, in the order of the report.
inline std::vector<core::Check> failed(const std::vector<core::CheckResult>& results) {
    std::vector<core::Check> checks;
    for (const core::CheckResult& result : results) {
        if (!result.ok()) checks.push_back(result.check);
    }
    return checks;
}

}  // namespace asv::test
