#pragma once

#include <cstddef>

namespace asv::core {

/// Settings of the steering that follows the requirements instead of stopping at them.
struct SlideOptions {
    bool slide = true;       ///< off: straight motions only, stopped by what they meet
    double step = 0.03;      ///< longest constrained step, root mean square motion of the ASVs
    double margin = 0.002;   ///< gap kept to obstacles where there is room
    double hair = 5e-6;      ///< least gap, where the place is so tight that the margin closes it
    double progress = 0.05;  ///< share of its step by which a step has to come nearer
    std::size_t max_steps = 200;  ///< of one call
};

}  // namespace asv::core
