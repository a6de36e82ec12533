#include "tools/solve/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/solve/idle_settings.hpp"

namespace asv::tools {

namespace {

/// Beyond so many primitive steps a file of them is of little use.
constexpr double many_steps = 100'000;

/// Any path has about so many, since some point has to come from its start to its goal.
double least_steps(const core::Problem& problem) {
    double farthest = 0;
    for (std::size_t i = 0; i < problem.start.size(); ++i) {
        const core::Point &from = problem.start[i], &to = problem.goal[i];
        farthest = std::max(farthest, std::hypot(to.x - from.x, to.y - from.y));
    }
    return farthest / problem.requirements.max_step;
}

void warn_of_many_steps(const SolveArguments& arguments, const io::ProblemFile& file) {
    const double steps = least_steps(file.problem);
    if (!(steps > many_steps)) return;
    std::ostringstream text;
    text << arguments.problem << ':' << file.goal_line << ": warning: from start to goal it takes "
         << std::fixed << std::setprecision(0) << std::ceil(steps)
         << " primitive steps or more, since none is longer than " << std::defaultfloat
         << std::setprecision(6) << file.problem.requirements.max_step
         << "; the time to write them counts toward the limit\n";
    std::cerr << text.str();
}

void warn_of_idle_settings(const SolveArguments& arguments, const core::Problem& problem) {
    for (const std::string& setting : arguments.settings) {
        const std::string name = setting.substr(0, setting.find('='));
        const std::string why =
            core::why_without_effect(arguments.solve.planner, name, problem.body_kind());
        if (!why.empty())
            std::cerr << "asv-solve: warning: --set " << setting << " has no effect: " << why
                      << '\n';
    }
}

}  // namespace

void warn_of_doubtful(const SolveArguments& arguments, const io::ProblemFile& file) {
    if (arguments.quiet) return;
    warn_of_many_steps(arguments, file);
    warn_of_idle_settings(arguments, file.problem);
}

}  // namespace asv::tools
