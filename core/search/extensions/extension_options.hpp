#pragma once

#include <cstddef>
#include <vector>

#include "core/search/extensions/exhaustion.hpp"
#include "core/search/extensions/passage_filter.hpp"
#include "core/search/extensions/reported.hpp"
#include "core/search/setting.hpp"

namespace asv::core {

/// Which extensions of RRT-Connect are on, and their parameters. What each field is, settings_of()
/// says below.
struct ExtensionOptions {
    bool swap_limiter = false;
    std::size_t swap_steps = 5000;
    double swap_step = 0.001;
    bool collision_swap = false;
    ExhaustionOptions exhaustion;
    bool neighbour_cost = false;
    double quality_floor = 0.1;
    bool passage = false;
    PassageFilter passage_filter;
    bool control_chosen = false;
    double control_reach = 1;
    bool goal_bias = false;
    double goal_probability = 0.05;

    bool any() const {
        return swap_limiter || collision_swap || exhaustion.kind != ExhaustionKind::off ||
               neighbour_cost || passage || control_chosen || goal_bias;
    }
};

/// Those of extensions 1 and 2: when the trees swap.
inline std::vector<Setting> settings_of_swaps(ExtensionOptions& options) {
    return {
        {.name = "swap-limiter",
         .meaning = "extension 1: swap the trees after some steps",
         .value = on_or_off(options.swap_limiter),
         .why = extension_is_off,
         .source = extensions_report},
        {.name = "swap-steps",
         .meaning = "steps after which the limiter swaps",
         .value = number(options.swap_steps, 0, 1e9),
         .why = "as reported",
         .source = extensions_report},
        {.name = "swap-step",
         .meaning = "length of a whole motion that counts as a step; 0: a thousandth of the "
                    "longest side",
         .value = number(options.swap_step, 0, 1e3, in_metric),
         .why = "the primitive step of the report",
         .source = extensions_report},
        {.name = "collision-swap",
         .meaning = "extension 2: swap the trees only after a connect that ended in a collision",
         .value = on_or_off(options.collision_swap),
         .why = extension_is_off,
         .source = extensions_report},
    };
}

/// Those of extension 4 and the switch of extension 5: which samples are kept.
inline std::vector<Setting> settings_of_quality(ExtensionOptions& options) {
    return {
        {.name = "neighbour-cost",
         .meaning = "extension 4: keep samples by the quality of their nearest node",
         .value = on_or_off(options.neighbour_cost),
         .why = extension_is_off,
         .source = "Urmson and Simmons 2003"},
        {.name = "quality-floor",
         .meaning = "least probability of keeping one",
         .value = number(options.quality_floor, 0, 1),
         .why = "the number is reported, as a cap; a floor is what the paper's text asks for",
         .source = "Urmson and Simmons 2003"},
        {.name = "passage-filter",
         .meaning = "extension 5: keep samples around which some, but not all, draws collide",
         .value = on_or_off(options.passage),
         .why = extension_is_off,
         .source = extensions_report},
    };
}

/// Those of extensions 6 and 7: samples near the goal, and the goal itself.
inline std::vector<Setting> settings_of_goals(ExtensionOptions& options) {
    return {
        {.name = "control-chosen",
         .meaning = "extension 6: keep samples that are not farther from the goal than the start",
         .value = on_or_off(options.control_chosen),
         .why = extension_is_off,
         .source = extensions_report},
        {.name = "control-reach",
         .meaning = "what that distance is multiplied by",
         .value = number(options.control_reach, 0, 1e3),
         .why = "as reported: the distance of the start itself",
         .source = extensions_report},
        {.name = "goal-bias",
         .meaning = "extension 7: sometimes sample the other tree's root",
         .value = on_or_off(options.goal_bias),
         .why = extension_is_off,
         .source = extensions_report},
        {.name = "goal-probability",
         .meaning = "how often",
         .value = number(options.goal_probability, 0, 1),
         .why = "that of RRT; the report gives none",
         .source = "own"},
    };
}

/// Those of all seven, in the order of their numbers.
inline std::vector<Setting> settings_of(ExtensionOptions& options) {
    return joined({settings_of_swaps(options), settings_of(options.exhaustion),
                   settings_of_quality(options), settings_of(options.passage_filter),
                   settings_of_goals(options)});
}

}  // namespace asv::core
