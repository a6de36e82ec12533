#include "core/model/problem.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "core/model/cost.hpp"
#include "core/model/path.hpp"
#include "tools/python/binding/module.hpp"
#include "tools/python/binding/support/arrays.hpp"

namespace asv::python {

namespace {

using core::Problem;
using core::Requirements;
using core::Solution;
using namespace py::literals;

Requirements make_requirements(double broom_length, double max_step, double area_radius_per_broom,
                               const std::optional<Array>& bounds, double tolerance) {
    Requirements made;
    made.broom_length = broom_length;
    made.max_step = max_step;
    made.area_radius_per_broom = area_radius_per_broom;
    made.tolerance = tolerance;
    if (!(broom_length > 0 && max_step > 0 && area_radius_per_broom >= 0 && tolerance >= 0))
        throw std::invalid_argument(
            "broom_length and max_step have to be above 0, area_radius_per_broom and tolerance at "
            "least 0");
    made.bounds = core::without_bounds();
    if (bounds) {
        const auto corners = to_points(*bounds, "bounds");
        if (corners.size() != 2 || !(corners[0].x < corners[1].x && corners[0].y < corners[1].y))
            throw std::invalid_argument(
                "bounds: expected the low and the high corner of a rectangle with an area, or "
                "None for an endless plane");
        made.bounds = {corners[0], corners[1]};
    }
    return made;
}

py::object bounds_of(const Requirements& requirements) {
    if (!requirements.bounded()) return py::none();
    const geometry::Box& box = requirements.bounds;
    return py::make_tuple(py::make_tuple(box.low.x, box.low.y),
                          py::make_tuple(box.high.x, box.high.y));
}

void bind_requirements(py::module_& module) {
    const Requirements usual;
    const py::object unit_square = bounds_of(usual);
    py::class_<Requirements>(module, "Requirements",
                             "What every primitive step has to meet; lengths in workspace units.")
        .def(py::init(&make_requirements), py::kw_only(), "broom_length"_a = usual.broom_length,
             "max_step"_a = usual.max_step, "area_radius_per_broom"_a = usual.area_radius_per_broom,
             "bounds"_a = unit_square, "tolerance"_a = usual.tolerance,
             "bounds: ((low x, low y), (high x, high y)), or None for an endless plane.")
        .def_readonly("broom_length", &Requirements::broom_length,
                      "Distance of neighbouring ASVs, workspace units.")
        .def_readonly("max_step", &Requirements::max_step,
                      "Farthest any ASV may move in one primitive step, workspace units.")
        .def_readonly("area_radius_per_broom", &Requirements::area_radius_per_broom,
                      "r of the least area pi (r (n - 1))^2 of n ASVs, workspace units.")
        .def_property_readonly("bounds", &bounds_of,
                               "((low x, low y), (high x, high y)), or None: no end.")
        .def_readonly("tolerance", &Requirements::tolerance,
                      "How lenient a verdict is, in the unit of each requirement.")
        .def("min_area", &Requirements::min_area, "asv_count"_a,
             "The least area of the closed polygon of so many ASVs, square workspace units.");
}

py::list joints_of(const core::PlanarArm& arm) {
    py::list joints;
    for (const core::JointRange& joint : arm.joints) {
        if (joint.wraps)
            joints.append("wrap");
        else
            joints.append(py::make_tuple(joint.low, joint.high));
    }
    return joints;
}

void bind_arm(py::module_& module) {
    using core::PlanarArm;
    py::class_<PlanarArm>(module, "Arm",
                          "Links one behind the other, the first of which turns about a base.")
        .def_readonly("links", &PlanarArm::links, "Lengths from the base to the tip.")
        .def_property_readonly("joints", &joints_of,
                               "For each joint \"wrap\" or its range (low, high), radians.")
        .def_property_readonly(
            "angles",
            [](const PlanarArm& arm) {
                return arm.angles == core::AngleReference::previous_link ? "relative" : "absolute";
            },
            "What angles are measured from: the link before (\"relative\") or the x axis "
            "(\"absolute\").")
        .def_readonly("start", &PlanarArm::start, "Joint angles, radians.")
        .def_readonly("goal", &PlanarArm::goal, "Joint angles, radians.");
}

Problem make_problem(const Array& start, const Array& goal, const Array& obstacles,
                     const std::optional<Requirements>& requirements, const std::string& body) {
    Problem problem;
    problem.start = to_points(start, "start");
    problem.goal = to_points(goal, "goal");
    problem.obstacles = to_boxes(obstacles, "obstacles");
    if (requirements) problem.requirements = *requirements;
    if (problem.start.empty() || problem.start.size() != problem.goal.size())
        throw std::invalid_argument("start and goal need the same number of points, at least one");
    if (body == "point")
        problem.body = core::PointBody{};
    else if (body != "chain")
        throw std::invalid_argument(
            "body has to be \"chain\" or \"point\"; an arm is made by "
            "parse_scenario()");
    if (body == "point" && problem.start.size() != 1)
        throw std::invalid_argument("a body \"point\" has one point in start and goal");
    return problem;
}

py::array ends_of(const std::vector<geometry::Point>& points, py::handle owner) {
    return view(points, {static_cast<py::ssize_t>(points.size()), 2}, owner);
}

const char* body_of(const Problem& problem) {
    constexpr const char* words[] = {"chain", "arm", "point"};
    return words[static_cast<std::size_t>(problem.body_kind())];
}

void bind_problem_class(py::module_& module) {
    py::class_<Problem>(
        module, "Problem",
        "Where the ASVs stand, where they shall go, and the rectangles among which they move.\n\n"
        "A problem does not change once it is made, so threads may share it. Its arrays are "
        "read-only views of its own memory; lengths are in workspace units.")
        .def(py::init(&make_problem), "start"_a, "goal"_a, "obstacles"_a = py::tuple(),
             py::kw_only(), "requirements"_a = py::none(), "body"_a = "chain",
             "start, goal: n x 2 positions in chain order. obstacles: m x 4 (low x, low y, high x, "
             "high y) or m x 2 x 2. body: \"chain\" or \"point\" (n = 1). Raises ValueError for "
             "another shape or a number that is not finite.")
        .def_property_readonly(
            "start", [](py::object self) { return ends_of(self.cast<Problem&>().start, self); },
            "Array n x 2: where each ASV starts. Of an arm its base, its joints and its tip.")
        .def_property_readonly(
            "goal", [](py::object self) { return ends_of(self.cast<Problem&>().goal, self); },
            "Array n x 2: where each ASV shall go.")
        .def_property_readonly(
            "obstacles",
            [](py::object self) { return view(self.cast<Problem&>().obstacles, self); },
            "Array m x 2 x 2: low and high corner of each closed rectangle.")
        .def_readonly("requirements", &Problem::requirements,
                      "What every primitive step has to meet.")
        .def_property_readonly("body", &body_of, "\"chain\", \"arm\" or \"point\".")
        .def_property_readonly("arm", &Problem::arm, py::return_value_policy::reference_internal,
                               "The arm; None for the other bodies.")
        .def_property_readonly("asv_count", &Problem::asv_count,
                               "Number of ASVs; of an arm its links and one more.")
        .def("__reduce__",
             [](const py::object& self) {
                 return py::module_::import("asv.problems").attr("_pickled_problem")(self);
             })
        .def("__repr__", [](const Problem& problem) {
            return "<asv.Problem: " + std::string(body_of(problem)) + " of " +
                   std::to_string(problem.asv_count()) + " points among " +
                   std::to_string(problem.obstacles.size()) + " obstacles>";
        });
}

core::Path to_path(const Array& states) {
    if (states.ndim() != 3 || states.shape(1) < 1 || states.shape(2) != 2)
        throw std::invalid_argument("path: expected an array states x ASVs x 2");
    core::Path path(static_cast<std::size_t>(states.shape(1)));
    path.reserve(static_cast<std::size_t>(states.shape(0)));
    std::vector<geometry::Point> state(path.asv_count());
    const double* at = states.data();
    for (py::ssize_t i = 0; i < states.shape(0); ++i) {
        for (geometry::Point& point : state) {
            point = {at[0], at[1]};
            at += 2;
        }
        path.push_back(state);
    }
    return path;
}

py::array path_of(py::object self) {
    const core::Path& path = self.cast<Solution&>().path;
    return view(
        path.points(),
        {static_cast<py::ssize_t>(path.size()), static_cast<py::ssize_t>(path.asv_count()), 2},
        self);
}

void bind_solution(py::module_& module) {
    py::class_<Solution>(module, "Solution",
                         "States from the start to the goal, a primitive step apart, and the cost "
                         "that is claimed for them. It does not change once it is made.")
        .def(py::init([](const Array& path, std::optional<double> cost) {
                 Solution solution{to_path(path), 0};
                 solution.cost = cost ? *cost : core::cost(solution.path);
                 return solution;
             }),
             "path"_a, "cost"_a = py::none(),
             "path: states x ASVs x 2, which is copied. cost: None: the distance that all ASVs "
             "move; for an arm use cost(problem, path).")
        .def_property_readonly("path", &path_of,
                               "Array states x ASVs x 2, workspace units; a read-only view.")
        .def_readonly("cost", &Solution::cost,
                      "Distance that all ASVs move, workspace units; of an arm radians.")
        .def_property_readonly(
            "steps", [](const Solution& s) { return s.path.empty() ? 0 : s.path.size() - 1; },
            "Number of primitive steps: one less than states.")
        .def("__reduce__",
             [](const py::object& self) {
                 return py::module_::import("asv.problems").attr("_pickled_solution")(self);
             })
        .def("__repr__", [](py::object self) {
            return py::str("<asv.Solution: cost {:.6g}, {} steps>")
                .format(self.attr("cost"), self.attr("steps"));
        });
}

}  // namespace

void bind_problem(py::module_& module) {
    bind_requirements(module);
    bind_arm(module);
    bind_problem_class(module);
    bind_solution(module);
    module.def(
        "cost",
        [](const Problem& problem, const Array& path) {
            const core::Path states = to_path(path);
            if (states.asv_count() != problem.asv_count())
                throw std::invalid_argument("path: another number of ASVs than the problem has");
            return core::cost(problem, states);
        },
        "problem"_a, "path"_a,
        "What a path (states x ASVs x 2) costs: the distance that all ASVs move, workspace units; "
        "for an arm the length of the way of its joint angles, radians.");
}

}  // namespace asv::python
