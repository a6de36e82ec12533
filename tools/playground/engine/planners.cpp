// The catalogue of planners and of their settings.

#include "core/solve/planner_catalogue.hpp"
#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

namespace {

Json to_json(const core::Setting& setting) {
    const core::SettingValue& value = setting.value;
    Json json = {{"key", setting.name},  {"meaning", setting.meaning}, {"unit", value.unit},
                 {"min", value.low},     {"max", value.high},          {"whole", value.whole},
                 {"words", value.words}, {"switch", value.is_switch()}};
    json["default"] = core::describe_value(setting);
    return json;
}

}  // namespace

Answer planners(const Request& /*request*/) {
    Answer answer;
    Json& list = answer.json["planners"] = Json::array();
    for (const std::string_view name : core::planner_names()) {
        core::Planner planner = core::planner_named(name);
        Json settings = Json::array();
        for (const core::Setting& setting : core::settings(planner))
            settings.push_back(to_json(setting));
        list.push_back({{"name", name},
                        {"summary", core::planner_summary(name)},
                        {"source", core::planner_source(name)},
                        {"settings", std::move(settings)}});
    }
    return answer;
}

}  // namespace asv::playground
