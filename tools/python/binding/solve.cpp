#include "core/solve/solve.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "tools/python/binding/module.hpp"
#include "tools/python/binding/planners.hpp"
#include "tools/python/binding/support/trees.hpp"
#include "tools/python/binding/support/watched_solve.hpp"

namespace asv::python {

namespace {

using core::Progress;
using core::SolveProgress;
using core::SolveResult;
using core::SolveStatistics;
using namespace py::literals;

void bind_progress(py::module_& module) {
    py::class_<SolveProgress>(module, "SolveProgress", "A look at the work while it runs.")
        .def_property_readonly(
            "iterations", [](const SolveProgress& p) { return p.search.iterations; },
            "Of the first thread's search.")
        .def_property_readonly(
            "nodes", [](const SolveProgress& p) { return p.search.nodes; },
            "Of its trees: [of the start, of the goal].")
        .def_readonly("cost", &SolveProgress::cost,
                      "Of the best path so far; None while there is none.")
        .def_readonly("elapsed", &SolveProgress::elapsed, "Seconds.");
}

void bind_statistics(py::module_& module) {
    py::class_<SolveStatistics>(module, "SolveStatistics", "What a run found and spent.")
        .def_readonly("time_to_first", &SolveStatistics::time_to_first,
                      "Seconds until there was a path.")
        .def_readonly("time_total", &SolveStatistics::time_total, "Seconds.")
        .def_readonly("cost_first", &SolveStatistics::cost_first,
                      "Of the first path, workspace units (an arm's in radians).")
        .def_readonly("cost", &SolveStatistics::cost, "Of the solution.")
        .def_readonly("cost_of_search", &SolveStatistics::cost_of_search,
                      "Of the path that the search ended with, before any shortcut.")
        .def_readonly("cost_lower_bound", &SolveStatistics::cost_lower_bound,
                      "No path costs less; 0 where there was no time for it.")
        .def_readonly("steps_lower_bound", &SolveStatistics::steps_lower_bound,
                      "No path has fewer primitive steps; 0 where not known.")
        .def_readonly("optimal", &SolveStatistics::optimal,
                      "The improvement had nothing left to gain.")
        .def_property_readonly(
            "tree_nodes",
            [](const SolveStatistics& s) {
                return py::make_tuple(s.tree_nodes[0], s.tree_nodes[1]);
            },
            "(of the start's tree, of the goal's tree).")
        .def_readonly("iterations", &SolveStatistics::iterations,
                      "Of the search that found the path.")
        .def_readonly("state_checks", &SolveStatistics::state_checks, "Of all threads.")
        .def_readonly("edge_checks", &SolveStatistics::edge_checks, "Of all threads.")
        .def_readonly("cost_history", &SolveStatistics::cost_history,
                      "(seconds, cost) whenever a better path was found.");
}

void bind_result(py::module_& module) {
    py::class_<SolveResult>(module, "SolveOutcome", "What solve() came to, see SolveResult.")
        .def_property_readonly("status",
                               [](const SolveResult& result) { return core::name(result.status); })
        .def_readonly("reason", &SolveResult::reason)
        .def_property_readonly(
            "solution",
            [](const SolveResult& result) { return result.solution ? &*result.solution : nullptr; },
            py::return_value_policy::reference_internal)
        .def_readonly("report", &SolveResult::report)
        .def_readonly("statistics", &SolveResult::statistics)
        .def("trees", &trees_of, "planner"_a, "asv_count"_a);
}

double seconds(double given, const char* name) {
    if (!std::isfinite(given) || given < 0)
        throw std::invalid_argument(std::string(name) + ": expected seconds, 0 or more");
    return given;
}

}  // namespace

io::SearchTrees trees_of(const SolveResult& result, const std::string& planner,
                         std::size_t asv_count) {
    io::SearchTrees trees{planner, asv_count, {}, {}};
    for (const core::TreePicture& tree : result.trees)
        trees.trees.push_back({std::string(core::name(tree.root)), tree.points, tree.parents});
    for (const auto& [a, b] : result.edges) trees.edges.push_back({a, b});
    return trees;
}

void bind_solve(py::module_& module) {
    bind_progress(module);
    bind_statistics(module);
    bind_result(module);
    module.def(
        "solve",
        [](const core::Problem& problem, const PlannerChoice& planner, std::uint64_t seed,
           double time_limit, const std::optional<std::size_t>& max_iterations, double optimize,
           std::size_t threads, bool reverse, bool keep_trees, bool certify_motion,
           bool find_bounds, const py::object& on_progress, const py::object& should_stop) {
            core::SolveOptions options;
            options.planner = planner.planner;
            options.seed = seed;
            options.time_limit = seconds(time_limit, "time_limit");
            if (max_iterations) options.max_iterations = *max_iterations;
            options.optimize = seconds(optimize, "optimize");
            options.threads = threads;
            options.reverse = reverse;
            options.keep_trees = keep_trees;
            options.certify_motion = certify_motion;
            options.find_bounds = find_bounds;
            return solve_watched(problem, std::move(options), on_progress, should_stop);
        },
        "problem"_a, "planner"_a, py::kw_only(), "seed"_a, "time_limit"_a, "max_iterations"_a,
        "optimize"_a, "threads"_a, "reverse"_a, "keep_trees"_a, "certify_motion"_a, "find_bounds"_a,
        "on_progress"_a, "should_stop"_a);
    module.def(
        "invalid_ends",
        [](const core::Problem& problem) {
            py::list ends;
            for (const core::InvalidEnd& end : core::invalid_ends(problem))
                ends.append(py::make_tuple(end.goal ? "goal" : "start", end.reason));
            return ends;
        },
        "problem"_a);
}

}  // namespace asv::python
