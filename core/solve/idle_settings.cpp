#include "core/solve/idle_settings.hpp"

#include <algorithm>
#include <array>

namespace asv::core {

namespace {

/// A setting that does nothing where another one has a value, a number as in SettingValue.
struct Dependence {
    std::string_view setting, other;
    double idle_at = 0;
};

constexpr auto by_whole_motions = static_cast<double>(ExtendBy::whole);
constexpr auto by_steps = static_cast<double>(ExtendBy::steps);

constexpr std::array dependences{Dependence{"swap-steps", "swap-limiter"},
                                 Dependence{"swap-step", "swap-limiter"},
                                 Dependence{"quality-floor", "neighbour-cost"},
                                 Dependence{"control-reach", "control-chosen"},
                                 Dependence{"goal-probability", "goal-bias"},
                                 Dependence{"enlarge-tries", "enlarge"},
                                 Dependence{"enlarge-share", "enlarge"},
                                 Dependence{"extend-step", "extend", by_whole_motions},
                                 Dependence{"extend-nodes", "extend", by_whole_motions},
                                 Dependence{"swap-step", "extend", by_steps},
                                 Dependence{"enlarge", "extend", by_steps},
                                 Dependence{"enlarge-tries", "extend", by_steps},
                                 Dependence{"enlarge-share", "extend", by_steps},
                                 Dependence{"ladder", "extend", by_steps},
                                 Dependence{"step", "extend", by_steps}};

bool is_among(const std::vector<Setting>& settings, std::string_view name) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Setting& setting) { return setting.name == name; });
}

/// What is for chains alone, of the planners that have such settings.
bool is_for_chains(const Planner& planner, std::string_view setting) {
    if (std::holds_alternative<AutoPlanner>(planner)) return true;
    if (!std::holds_alternative<RrtConnectPlanner>(planner)) return false;
    LadderOptions ladder;
    return is_among(settings_of(ladder), setting);
}

/// What keeps the dependent setting from having an effect: "swap-limiter is off"; empty if nothing.
std::string why_idle(Planner planner, const Dependence& dependence) {
    for (const Setting& s : settings(planner))
        if (s.name == dependence.other && s.value.get() == dependence.idle_at)
            return s.name + " is " + describe_value(s);
    return "";
}

/// Settings of samplers that are not drawn from.
std::string idle_sampler(const SamplerOptions& options, std::string_view setting) {
    const auto used = [&](std::initializer_list<SamplerKind> kinds) {
        return std::any_of(kinds.begin(), kinds.end(), [&](SamplerKind kind) {
            return options.kind == kind || (options.kind == SamplerKind::mix &&
                                            options.weights[static_cast<std::size_t>(kind)] > 0);
        });
    };
    using enum SamplerKind;
    bool idle = false;
    if (setting.starts_with("mix-")) idle = options.kind != mix;
    if (setting == "sigma") idle = !used({gaussian, bridge, passage});
    if (setting == "grid-cells") idle = !used({grid});
    if (setting == "passage-draws") idle = !used({passage});
    return idle ? "the sampler that is chosen does not use it" : "";
}

}  // namespace

std::string why_without_effect(const Planner& planner, std::string_view setting, BodyKind body) {
    if (body != BodyKind::chain && is_for_chains(planner, setting))
        return std::string("it is for chains, and the body is ") +
               (body == BodyKind::arm ? "an arm" : "a point");
    for (const Dependence& dependence : dependences) {
        if (dependence.setting != setting) continue;
        if (std::string why = why_idle(planner, dependence); !why.empty()) return why;
    }
    const SamplerOptions* sampler = sampler_options(planner);
    return sampler ? idle_sampler(*sampler, setting) : "";
}

}  // namespace asv::core
