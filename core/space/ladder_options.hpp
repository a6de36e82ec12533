#pragma once

#include <cstddef>
#include <vector>

#include "core/search/setting.hpp"

namespace asv::core {

/// Options of the C-space as the bidirectional RRT for ASVs uses it; each part can be switched
/// off. What each field is, settings_of() says below.
struct LadderOptions {
    bool stepwise = true;
    bool corridor = true;
    bool corridor_reversed = true;
    double widest_corridor = 0.2;
    bool limit_angles = true;
    std::size_t lift_after = 50;
    std::size_t lifted_for = 50;
    double heading_weight = 0.5;
    bool enlarge = true;
    std::size_t enlarge_tries = 10;
    double enlarge_share = 0.05;
    bool ladder = true;
    double step = 0.001;
};

inline constexpr const char* ladder_report = "report on the bidirectional RRT for ASVs";

/// Those of what is sampled, and of the distance.
inline std::vector<Setting> settings_of_sampling(LadderOptions& options) {
    return {
        {.name = "stepwise",
         .meaning = "sample dimension by dimension from anywhere",
         .value = on_or_off(options.stepwise),
         .why = "one draw in ten is valid, of a chain drawn whole a few in a million",
         .source = ladder_report},
        {.name = "corridor",
         .meaning = "sample with ASV 1 in a gap between obstacles",
         .value = on_or_off(options.corridor),
         .why = "as reported: the way leads through the gaps",
         .source = ladder_report},
        {.name = "corridor-reversed",
         .meaning = "sample with the last ASV in a gap between obstacles",
         .value = on_or_off(options.corridor_reversed),
         .why = "as reported: either end may go first",
         .source = ladder_report},
        {.name = "widest-corridor",
         .meaning = "gap between obstacles that counts as a corridor",
         .value = number(options.widest_corridor, 1e-3, 10, workspace_units),
         .why = "a round number, four brooms; the report gives none",
         .source = "own"},
        {.name = "limit-angles",
         .meaning = "sample no turn sharper than the sharpest of start and goal",
         .value = on_or_off(options.limit_angles),
         .why = "as reported",
         .source = ladder_report},
        {.name = "lift-after",
         .meaning = "failed samples in a row that lift the limit of angles",
         .value = number(options.lift_after, 1, 1e6),
         .why = "a round number; the report says \"too often\"",
         .source = "own"},
        {.name = "lifted-for",
         .meaning = "samples for which it stays lifted",
         .value = number(options.lifted_for, 1, 1e6),
         .why = "a round number; the report says \"for a while\"",
         .source = "own"},
        {.name = "heading-weight",
         .meaning = "weight of the heading in the distance",
         .value = number(options.heading_weight, 0, 100, "units/radian"),
         .why = "heavy, as reported, so that no half turn is asked for in a corridor; the number "
                "is a round one",
         .source = ladder_report},
    };
}

/// Those of what happens where an extension is blocked.
inline std::vector<Setting> settings_of_steering(LadderOptions& options) {
    return {
        {.name = "enlarge",
         .meaning = "angle enlargement where an extension is blocked",
         .value = on_or_off(options.enlarge),
         .why = "as reported",
         .source = ladder_report},
        {.name = "enlarge-tries",
         .meaning = "how often the angles open a little more",
         .value = number(options.enlarge_tries, 1, 1000),
         .why = "as reported",
         .source = ladder_report},
        {.name = "enlarge-share",
         .meaning = "share by which the turns shrink each time",
         .value = number(options.enlarge_share, 1e-4, 0.9),
         .why = "a round number; the report says \"a little\"",
         .source = "own"},
        {.name = "ladder",
         .meaning = "ladder moves where an extension is blocked",
         .value = on_or_off(options.ladder),
         .why = "as reported",
         .source = ladder_report},
        {.name = "step",
         .meaning = "resolution of an extension, largest motion of an ASV",
         .value = number(options.step, 1e-5, 0.1, workspace_units),
         .why = "the longest primitive step, as reported",
         .source = ladder_report},
    };
}

inline std::vector<Setting> settings_of(LadderOptions& options) {
    return joined({settings_of_sampling(options), settings_of_steering(options)});
}

}  // namespace asv::core
