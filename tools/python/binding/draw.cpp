#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "io/drawing/drawing.hpp"
#include "io/drawing/exhibit.hpp"
#include "io/player/player.hpp"
#include "io/solution/trees_file.hpp"
#include "tools/python/binding/module.hpp"
#include "tools/python/binding/support/arrays.hpp"

namespace asv::python {

namespace {

using io::Exhibit;
using io::SearchTree;
using io::SearchTrees;
using namespace py::literals;

void bind_trees(py::module_& module) {
    py::class_<SearchTree>(module, "SearchTree",
                           "One search tree, or the nodes of a roadmap, seen through ASV 1, the "
                           "tip of an arm or the point.")
        .def_readonly("root", &SearchTree::root, "\"start\", \"goal\" or \"roadmap\".")
        .def_property_readonly(
            "points",
            [](py::object self) {
                const auto& points = self.cast<const SearchTree&>().points;
                return view(points, {static_cast<py::ssize_t>(points.size()), 2}, self);
            },
            "Array nodes x 2, workspace units.")
        .def_property_readonly(
            "parents",
            [](const SearchTree& tree) {
                return py::array_t<std::int64_t>(static_cast<py::ssize_t>(tree.parents.size()),
                                                 tree.parents.data());
            },
            "Array of the parent of each node; -1 for a root.");
    py::class_<SearchTrees>(module, "SearchTrees", "What a planner has explored, for looking at.")
        .def_readonly("planner", &SearchTrees::planner, "Its name.")
        .def_readonly("asv_count", &SearchTrees::asv_count, "Of the problem.")
        .def_readonly("trees", &SearchTrees::trees,
                      "That of the start, that of the goal; or one alone.")
        .def_readonly("edges", &SearchTrees::edges,
                      "Of a roadmap: pairs of indices into trees[0].points.");
    module.def("read_trees", &io::read_trees, "file"_a,
               "Reads a file of asv-solve --trees. Raises ParseError or ReadError.");
    module.def("write_trees", &io::write_trees, "file"_a, "trees"_a,
               "Writes such a file, whole or not at all. Raises WriteError.");
}

Exhibit exhibit_of(const core::Problem& problem, std::optional<core::Solution> solution,
                   std::optional<SearchTrees> trees, std::optional<double> lower_bound,
                   std::string title, std::string planner) {
    if (solution && solution->path.asv_count() != problem.asv_count())
        throw std::invalid_argument("solution: another number of ASVs than the problem has");
    if (solution && solution->path.empty())
        throw std::invalid_argument("solution: there is no state in it");
    return io::make_exhibit({std::move(title), problem, std::move(solution), std::move(trees),
                             lower_bound, std::move(planner)});
}

io::PictureFormat format_named(const std::string& name) {
    if (name == "svg") return io::PictureFormat::svg;
    if (name == "png") return io::PictureFormat::png;
    if (name == "pdf") return io::PictureFormat::pdf;
    throw std::invalid_argument("there is no picture format '" + name +
                                "'; there are svg, png, pdf");
}

io::Theme theme_named(const std::string& name) {
    if (name == "light") return io::Theme::light;
    if (name == "dark") return io::Theme::dark;
    throw std::invalid_argument("there is no theme '" + name + "'; there are light, dark");
}

py::bytes draw(const Exhibit& exhibit, const std::string& format, const std::string& theme) {
    std::string bytes;
    {
        const py::gil_scoped_release release;
        bytes = io::draw_picture(exhibit, format_named(format), theme_named(theme));
    }
    return bytes;
}

}  // namespace

void bind_draw(py::module_& module) {
    const auto released = py::call_guard<py::gil_scoped_release>();
    bind_trees(module);
    py::class_<Exhibit>(module, "Exhibit", "What there is to see, measured and judged.");
    module.def("exhibit", &exhibit_of, released, "problem"_a, "solution"_a, "trees"_a,
               "lower_bound"_a, "title"_a, "planner"_a);
    module.def("draw", &draw, "exhibit"_a, "format"_a, "theme"_a,
               "The bytes of an svg, png or pdf.");
    module.def("player", &io::make_player, released, "exhibit"_a, "The HTML page of the player.");
}

}  // namespace asv::python
