#include "tools/python/binding/planners.hpp"

#include <string>

#include <pybind11/stl.h>

#include "core/search/setting.hpp"
#include "tools/python/binding/module.hpp"

namespace asv::python {

namespace {

using namespace py::literals;

/// The value as Python has it: a word, a bool, an int or a float.
py::object value_of(const core::Setting& setting) {
    const double value = setting.value.get();
    if (!setting.value.words.empty())
        return py::str(setting.value.words[static_cast<std::size_t>(value)]);
    if (setting.value.is_switch()) return py::bool_(value != 0);
    if (setting.value.whole) return py::int_(static_cast<long long>(value));
    return py::float_(value);
}

/// All that the catalogue says of the settings, one dict for each; asv.catalogue makes Settings of
/// them.
py::list describe_settings(PlannerChoice& choice) {
    PlannerChoice fresh{core::planner_named(core::name(choice.planner))};
    const auto settings = core::settings(choice.planner);
    const auto defaults = core::settings(fresh.planner);
    py::list all;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const core::Setting& setting = settings[i];
        all.append(py::dict("name"_a = setting.name, "meaning"_a = setting.meaning,
                            "value"_a = value_of(setting), "default"_a = value_of(defaults[i]),
                            "low"_a = setting.value.low, "high"_a = setting.value.high,
                            "unit"_a = setting.value.unit,
                            "words"_a = py::tuple(py::cast(setting.value.words)),
                            "range"_a = core::describe_range(setting), "why"_a = setting.why,
                            "source"_a = setting.source));
    }
    return all;
}

}  // namespace

void bind_planners(py::module_& module) {
    module.def("planner_names", &core::planner_names, "The planners, the default first.");
    py::class_<PlannerChoice>(module, "PlannerChoice", "A planner of the catalogue, see Planner.")
        .def(py::init(
                 [](const std::string& name) { return PlannerChoice{core::planner_named(name)}; }),
             "name"_a)
        .def_property_readonly(
            "name", [](const PlannerChoice& c) { return core::name(c.planner); }, "Its name.")
        .def_property_readonly(
            "summary",
            [](const PlannerChoice& c) { return core::planner_summary(core::name(c.planner)); },
            "What it does.")
        .def_property_readonly(
            "source",
            [](const PlannerChoice& c) { return core::planner_source(core::name(c.planner)); },
            "Who described it.")
        .def("describe_settings", &describe_settings, "A dict for each setting.")
        .def(
            "set",
            [](PlannerChoice& c, const std::string& setting, const std::string& value) {
                core::set(c.planner, setting, value);
            },
            "setting"_a, "value"_a, "Sets one setting from text. Raises ValueError.");
}

}  // namespace asv::python
