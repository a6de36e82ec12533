// Four ASVs into a harbour: plans, validates, draws a picture and makes a player.

#include <fstream>
#include <iostream>
#include <utility>

#include <asv/core/solve/solve.hpp>
#include <asv/core/validation/validate.hpp>
#include <asv/io/drawing/drawing.hpp>
#include <asv/io/player/player.hpp>

int main() {
    asv::core::Problem problem;
    problem.start = {{0.10, 0.20}, {0.15, 0.20}, {0.19, 0.23}, {0.19, 0.28}};
    problem.goal = {{0.75, 0.75}, {0.80, 0.75}, {0.84, 0.78}, {0.84, 0.83}};
    problem.obstacles = {{{0.45, 0.00}, {0.52, 0.55}}, {{0.45, 0.68}, {0.52, 1.00}}};

    asv::core::SolveOptions options;
    options.planner = asv::core::planner_named("rrt-connect");
    options.seed = 7;
    const asv::core::SolveResult result = asv::core::solve(problem, options);
    if (!result.solution) {
        std::cerr << name(result.status) << ": " << result.reason << '\n';
        return 1;
    }

    // solve() has done so already; this is how to check a solution from elsewhere.
    const bool valid = asv::core::validate(problem, *result.solution, {.continuous = true}).valid();
    std::cout << "cost " << result.solution->cost << (valid ? ", valid\n" : ", not valid\n");

    asv::io::ExhibitInput input{"harbour", problem, *result.solution};
    input.lower_bound = result.statistics.cost_lower_bound;
    const asv::io::Exhibit exhibit = make_exhibit(std::move(input));
    std::ofstream("harbour.svg") << draw_picture(exhibit, asv::io::PictureFormat::svg,
                                                 asv::io::Theme::light);
    std::ofstream("harbour.html") << make_player(exhibit);
    return valid ? 0 : 1;
}
