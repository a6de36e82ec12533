#pragma once

#include <cstddef>
#include <vector>

#include "core/search/setting.hpp"

namespace asv::core {

/// Options of the steering that follows the requirements instead of stopping at them; without
/// slides there are straight motions only. What each field is, settings_of() says below.
struct SlideOptions {
    bool slide = true;
    double step = 0.03;
    double margin = 0.002;
    double hair = 5e-6;
    double progress = 0.05;
    std::size_t max_steps = 200;
};

inline std::vector<Setting> settings_of(SlideOptions& options) {
    return {
        {.name = "slide",
         .meaning = "slide along what blocks a straight motion",
         .value = on_or_off(options.slide),
         .why = "off takes twice as long on 15ASV of the field, though less on easier problems",
         .source = "own"},
        {.name = "slide-step",
         .meaning = "longest constrained step, root mean square motion of the ASVs",
         .value = number(options.step, 1e-4, 0.5, workspace_units),
         .why = "half of it is slower in corridors and faster through clutter, so every second "
                "thread has that",
         .source = "own"},
        {.name = "slide-margin",
         .meaning = "gap kept to obstacles where there is room",
         .value = number(options.margin, 1e-6, 0.1, workspace_units),
         .why = "a round number, two primitive steps; where it closes the way it falls to "
                "slide-hair",
         .source = "own"},
        {.name = "slide-hair",
         .meaning = "least gap, where the place is tight",
         .value = number(options.hair, 1e-7, 0.01, workspace_units),
         .why = "half of the tolerance of 1e-5; corridors of 1.01 times the least height of a flat "
                "chain are passed",
         .source = "own"},
        {.name = "slide-progress",
         .meaning = "share of its length by which a constrained step has to come nearer",
         .value = number(options.progress, 0, 1),
         .why = "a round number",
         .source = "own"},
        {.name = "slide-steps",
         .meaning = "most constrained steps of one slide",
         .value = number(options.max_steps, 1, 1e6),
         .why = "a round number; they lead six times across the unit square",
         .source = "own"},
    };
}

}  // namespace asv::core
