#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/stl.h>

#include "core/search/sampling/samplers.hpp"
#include "core/solve/bodies/search_in.hpp"
#include "tools/python/binding/module.hpp"
#include "tools/python/binding/planners.hpp"
#include "tools/python/binding/support/arrays.hpp"
#include "tools/python/binding/support/python_space.hpp"

namespace asv::python {

namespace {

using core::Rng;
using core::SearchResult;
using namespace py::literals;
using Space = core::SampledBy<PythonSpace>;

/// What a search in a space of one's own takes besides the planner.
struct Question {
    py::object space;
    std::vector<double> start, goal;
    core::Limits limits;
    py::object on_progress;
};

/// Called in each iteration: lets Ctrl-C in, tells Python.
core::Observer observer_of(const py::object& on_progress) {
    return [on_progress](const core::Progress& progress) {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!on_progress.is_none())
            on_progress(progress.iterations, progress.nodes,
                        std::isfinite(progress.cost) ? py::cast(progress.cost) : py::none());
    };
}

SearchResult search(const Question& question, const core::Planner& planner, Rng& rng) {
    const PythonSpace plain(question.space, question.start.size());
    const core::SamplerOptions* sampler = core::sampler_options(planner);
    if (sampler == nullptr)
        throw std::invalid_argument(
            "planner auto slides chains; choose another one for a space of "
            "one's own");
    const bool needs_sigma = sampler->kind != core::SamplerKind::own;
    Space space(needs_sigma ? core::sampler_for(plain, *sampler)
                            : core::make_sampler<PythonSpace>(*sampler),
                plain);
    return std::visit(
        [&](const auto& chosen) -> SearchResult {
            if constexpr (std::is_same_v<std::decay_t<decltype(chosen)>, core::AutoPlanner>)
                return {};
            else
                return core::search_in(space, chosen, {question.start, question.goal},
                                       question.limits, rng, observer_of(question.on_progress));
        },
        planner);
}

py::tuple tree_of(const core::Tree& tree, std::size_t dimension) {
    std::vector<double> rows;
    std::vector<std::int64_t> parents;
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        const auto row = tree.row(node);
        rows.insert(rows.end(), row.begin(), row.end());
        parents.push_back(tree.parent(node) == core::Tree::none ? -1 : tree.parent(node));
    }
    const auto count = static_cast<py::ssize_t>(tree.size());
    return py::make_tuple(copy(rows, {count, static_cast<py::ssize_t>(dimension)}),
                          py::array_t<std::int64_t>(count, parents.data()));
}

double cost_of(const PythonSpace& space, const core::Configurations& path) {
    const std::size_t d = space.dimension();
    const std::span<const double> rows(path);
    double cost = 0;
    for (std::size_t i = d; i < rows.size(); i += d)
        cost += space.cost(rows.subspan(i - d, d), rows.subspan(i, d));
    return cost;
}

/// What asv.searching makes a SearchResult of.
py::dict answer(const Question& question, const SearchResult& found) {
    const std::size_t d = question.start.size();
    py::list trees;
    for (const core::Tree& tree : found.trees) trees.append(tree_of(tree, d));
    const bool solved = found.outcome == core::Outcome::solved;
    const auto states = static_cast<py::ssize_t>(found.path.size() / d);
    py::object path = py::none(), cost = py::none();
    if (solved) {
        path = copy(found.path, {states, static_cast<py::ssize_t>(d)});
        cost = py::cast(cost_of(PythonSpace(question.space, d), found.path));
    }
    return py::dict("outcome"_a = core::name(found.outcome), "path"_a = path, "cost"_a = cost,
                    "trees"_a = trees, "edges"_a = found.edges, "iterations"_a = found.iterations);
}

py::dict search_space(const py::object& space, std::vector<double> start, std::vector<double> goal,
                      const PlannerChoice& planner, std::uint64_t seed, std::size_t max_iterations,
                      std::optional<std::size_t> max_nodes, std::optional<double> time_limit,
                      const py::object& on_progress) {
    if (start.empty() || start.size() != goal.size())
        throw std::invalid_argument("start and goal need the same number of coordinates");
    Question question{space, std::move(start), std::move(goal), {}, on_progress};
    question.limits.max_iterations = max_iterations;
    if (max_nodes) question.limits.max_nodes = *max_nodes;
    if (time_limit)
        question.limits.deadline =
            core::Clock::now() + std::chrono::duration_cast<core::Clock::duration>(
                                     std::chrono::duration<double>(*time_limit));
    const PythonSpace checked(space, question.start.size());
    for (const auto* end : {&question.start, &question.goal})
        if (!checked.valid(*end))
            throw std::invalid_argument(end == &question.start ? "the start is not valid"
                                                               : "the goal is not valid");
    Rng rng(seed);
    return answer(question, search(question, planner.planner, rng));
}

void bind_rng(py::module_& module) {
    py::class_<Rng>(module, "Rng", "A stream of random numbers, the same on every machine.")
        .def(py::init<std::uint64_t>(), "seed"_a)
        .def(
            "uniform", [](Rng& rng, double low, double high) { return rng.uniform(low, high); },
            "low"_a = 0.0, "high"_a = 1.0, "Uniform in [low, high).")
        .def("normal", &Rng::normal, "Standard normal.")
        .def(
            "below",
            [](Rng& rng, std::uint32_t count) {
                if (count == 0) throw std::invalid_argument("below: count has to be above 0");
                return rng.below(count);
            },
            "count"_a, "Uniform in 0, ..., count - 1.")
        .def("chance", &Rng::chance, "probability"_a, "True with that probability.");
}

}  // namespace

void bind_space(py::module_& module) {
    bind_rng(module);
    module.def("search", &search_space, "space"_a, "start"_a, "goal"_a, "planner"_a, py::kw_only(),
               "seed"_a, "max_iterations"_a, "max_nodes"_a, "time_limit"_a, "on_progress"_a);
}

}  // namespace asv::python
