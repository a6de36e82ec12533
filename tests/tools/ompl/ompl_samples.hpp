#pragma once

#include "tests/kit/chains/problems.hpp"

namespace asv::test {

/// Three ASVs past a box.
inline core::Problem past_a_box() {
    return problem({{0.10, 0.50}, {0.15, 0.50}, {0.15, 0.55}},
                   {{0.80, 0.50}, {0.85, 0.50}, {0.85, 0.55}}, {{{0.4, 0.3}, {0.6, 0.8}}});
}

/// A point before a wall that is so thin that samples of the straight way lie on both sides of it.
inline core::Problem before_a_thin_wall() {
    core::Problem problem;
    problem.body = core::PointBody{};
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.9, 0.5}};
    problem.obstacles = {{{0.4999, 0.0}, {0.5001, 0.9}}};
    return problem;
}

}  // namespace asv::test
