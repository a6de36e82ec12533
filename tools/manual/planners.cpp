#include "tools/manual/planners.hpp"

#include "core/solve/planner_catalogue.hpp"

namespace asv::tools::manual {

std::vector<PlannerChoice> planner_choices() {
    std::vector<PlannerChoice> choices;
    for (const auto name : core::planner_names()) {
        core::Planner planner = core::planner_named(name);
        PlannerChoice choice{std::string(name), std::string(core::planner_summary(name)), {}};
        for (const core::Setting& setting : core::settings(planner)) {
            std::vector<std::string> words = setting.value.words;
            if (setting.value.is_switch()) words = {"off", "on"};
            choice.settings.push_back({setting.name, setting.meaning, words});
        }
        choices.push_back(std::move(choice));
    }
    return choices;
}

}  // namespace asv::tools::manual
