#include "io/problem/many_steps.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

/// More primitive steps than this are a slip in the unit rather than a wish.
constexpr double many_steps = 1e5;

/// The least of 1, 2 and 5 times a power of ten that is no less than the positive length.
double rounded_up(double length) {
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= length) return digit * power;
    return 10 * power;
}

}  // namespace

double largest_step(const core::Problem& problem) {
    const core::PlanarArm* arm = problem.arm();
    return arm ? *std::min_element(arm->links.begin(), arm->links.end()) : largest_number;
}

std::optional<std::string> why_so_many_steps(const core::Problem& problem) {
    double farthest = 0;
    for (std::size_t i = 0; i < problem.start.size(); ++i) {
        const core::Point& from = problem.start[i];
        const core::Point& to = problem.goal[i];
        farthest = std::max(farthest, std::hypot(to.x - from.x, to.y - from.y));
    }
    const double steps = farthest / problem.requirements.max_step;
    if (!(steps > many_steps)) return std::nullopt;
    std::ostringstream text;
    text << "any path has " << steps << " steps of " << problem.requirements.max_step << " or more";
    const double fitting = rounded_up(farthest / many_steps);
    if (fitting <= largest_step(problem)) text << " (a \"step\" of " << fitting << " would fit)";
    text << ": the goal is " << farthest << " away";
    return text.str();
}

}  // namespace asv::io
