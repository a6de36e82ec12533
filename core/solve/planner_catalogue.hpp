#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "core/model/body.hpp"
#include "core/search/extensions/extension_options.hpp"
#include "core/search/prm.hpp"
#include "core/search/rrt.hpp"
#include "core/search/rrt_connect.hpp"
#include "core/search/rrt_star.hpp"
#include "core/search/sampling/sampler_options.hpp"
#include "core/search/setting.hpp"
#include "core/search/slide_and_pull.hpp"
#include "core/search/trees/single_steps.hpp"
#include "core/space/ladder_options.hpp"
#include "core/space/steering/slide_options.hpp"

/// The planners by name, and their settings by name: what a command line can choose from.

namespace asv::core {

/// `auto`: slides and pulls between two trees.
struct AutoPlanner {
    SlideOptions steering;
    SlideAndPullOptions search;
};

/// `rrt-connect`: the bidirectional RRT for ASVs with corridor sampling, angle enlargement and
/// ladder moves, and seven extensions, all off.
struct RrtConnectPlanner {
    LadderOptions space;
    RrtConnectOptions search;
    SingleStepOptions single_steps;
    ExtensionOptions extensions;
    SamplerOptions sampler;
};

/// `rrt`. Lengths of 0, here and below, stand for shares of the space; see search_in.hpp.
struct RrtPlanner {
    RrtOptions search{.step = 0};
    SamplerOptions sampler;
};

/// `rrt-star`.
struct RrtStarPlanner {
    RrtStarOptions search{.step = 0};
    SamplerOptions sampler;
};

/// The roadmaps, which differ in where their samples come from.
struct PrmPlanner {
    PrmOptions search;
    SamplerOptions sampler;
};
struct PrmGridPlanner : PrmPlanner {
    PrmGridPlanner() { sampler.kind = SamplerKind::grid; }
};
struct PrmRandomPlanner : PrmPlanner {
    PrmRandomPlanner() { sampler.kind = SamplerKind::uniform; }
};
struct PrmGaussianPlanner : PrmPlanner {
    PrmGaussianPlanner() { sampler.kind = SamplerKind::gaussian; }
};
struct PrmBridgePlanner : PrmPlanner {
    PrmBridgePlanner() { sampler.kind = SamplerKind::bridge; }
};

using Planner =
    std::variant<AutoPlanner, RrtConnectPlanner, RrtPlanner, RrtStarPlanner, PrmGridPlanner,
                 PrmRandomPlanner, PrmGaussianPlanner, PrmBridgePlanner>;

/// The names that planner_named() knows, the default first.
std::vector<std::string_view> planner_names();

/// What one line of documentation says of a planner.
std::string_view planner_summary(std::string_view name);

/// Who described it.
std::string_view planner_source(std::string_view name);

/// The planner with its default settings. Throws std::invalid_argument for an unknown name.
Planner planner_named(std::string_view name);

/// Name of the planner that is chosen.
std::string_view name(const Planner& planner);

/// The settings of the planner, which has to outlive them; those of its sampler come last.
std::vector<Setting> settings(Planner& planner);

/// The options of its sampler; nullptr for a planner that has none.
const SamplerOptions* sampler_options(const Planner& planner);

/// Sets one setting. Throws std::invalid_argument, which says what there is and which planners have
/// that setting, for an unknown name or a value that is out of range.
void set(Planner& planner, std::string_view setting, std::string_view value);

/// Throws std::invalid_argument when the settings contradict each other or do not suit the body.
void require_usable(const Planner& planner, BodyKind body);

}  // namespace asv::core
