#include "core/validation/validate.hpp"

#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "core/validation/report.hpp"
#include "tools/python/binding/module.hpp"
#include "tools/python/binding/support/arrays.hpp"

namespace asv::python {

namespace {

using core::CheckResult;
using core::Offender;
using core::Problem;
using core::Solution;
using core::ValidationReport;
using namespace py::literals;

void bind_offender(py::module_& module) {
    py::class_<Offender>(module, "Offender",
                         "One violation or, where there is none, the state nearest to one. All "
                         "numbers count from 0.")
        .def_readonly("state", &Offender::state, "Row of the path; of a step, its end.")
        .def_readonly("asv", &Offender::asv, "The ASV, point or joint to blame, or None.")
        .def_readonly("broom", &Offender::broom, "The broom or link to blame, or None.")
        .def_readonly("obstacle", &Offender::obstacle, "The obstacle that is met, or None.")
        .def_readonly("time", &Offender::time,
                      "In [0, 1] between the state before and this one, or None.")
        .def_readonly("room", &Offender::room,
                      "What is left to the limit, in the unit of the requirement; negative: "
                      "violated by that much.");
}

void bind_check(py::module_& module) {
    py::class_<CheckResult>(module, "CheckResult", "The outcome of one check over all states.")
        .def_property_readonly(
            "name", [](const CheckResult& result) { return core::name(result.check); },
            "Which requirement: \"ends\", \"steps\", \"broom lengths\", ...")
        .def_property_readonly("ok", &CheckResult::ok, "Do all states meet the requirement?")
        .def_readonly("states", &CheckResult::states, "How many states or steps were looked at.")
        .def_readonly("failures", &CheckResult::failures, "How many of them violate it.")
        .def_readonly("worst", &CheckResult::worst, "The Offender with the least room, or None.")
        .def_readonly("offenders", &CheckResult::offenders,
                      "The worst of each failed state, where they were asked for.")
        .def(
            "describe", [](const CheckResult& result) { return core::describe(result); },
            "One clause: \"broom 3 meets obstacle 5 by 0.0012\"; it counts from 1.")
        .def("__repr__", [](const CheckResult& result) {
            return "<asv.CheckResult: " + std::string(core::name(result.check)) + ": " +
                   core::describe(result) + ">";
        });
}

/// A line for each check, as asv-validate has it.
std::string text_of(const ValidationReport& report) {
    std::string text = report.valid() ? "valid" : "not valid";
    const auto add = [&](const CheckResult& result, const char* before) {
        text += "\n" + std::string(result.ok() ? "  ok    " : "  FAILS ") + before +
                std::string(core::name(result.check)) + ": " + core::describe(result);
    };
    for (const CheckResult& result : report.checks) add(result, "");
    for (const CheckResult& result : report.motion) add(result, "motion, ");
    return text;
}

void bind_report(py::module_& module) {
    py::class_<ValidationReport>(module, "ValidationReport",
                                 "What the independent checker says; as text a line for each "
                                 "check.")
        .def_property_readonly("valid", &ValidationReport::valid, "Does every check hold?")
        .def_readonly("checks", &ValidationReport::checks, "A CheckResult for each requirement.")
        .def_readonly("motion", &ValidationReport::motion,
                      "The checks along the steps, where they were asked for.")
        .def_readonly("cost", &ValidationReport::cost,
                      "As computed here: workspace units, of an arm radians.")
        .def("__str__", &text_of)
        .def("__repr__", [](const ValidationReport& report) {
            return std::string("<asv.ValidationReport: ") +
                   (report.valid() ? "valid>" : "not valid>");
        });
}

}  // namespace

void bind_validate(py::module_& module) {
    bind_offender(module);
    bind_check(module);
    bind_report(module);
    module.def(
        "validate",
        [](const Problem& problem, const Solution& solution, double tolerance, bool continuous,
           bool list_offenders) {
            const py::gil_scoped_release release;
            return core::validate(problem, solution, {tolerance, continuous, list_offenders});
        },
        "problem"_a, "solution"_a, py::kw_only(), "tolerance"_a, "continuous"_a,
        "list_offenders"_a);
    module.def(
        "validate_state",
        [](const Problem& problem, const Array& state, double tolerance) {
            const auto points = to_points(state, "state");
            if (points.size() != problem.asv_count())
                throw std::invalid_argument("state: another number of ASVs than the problem has");
            return core::validate_state(problem, points, {.tolerance = tolerance});
        },
        "problem"_a, "state"_a, py::kw_only(), "tolerance"_a);
}

}  // namespace asv::python
