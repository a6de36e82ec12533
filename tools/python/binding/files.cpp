#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl/filesystem.h>

#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_file.hpp"
#include "io/solution/solution_file.hpp"
#include "tools/python/binding/module.hpp"

/// Reading and writing problems and solutions.

namespace asv::python {

namespace {

using namespace py::literals;

/// What was read, and what had to be forgiven as (file, line, message).
template <class Read>
py::tuple with_warnings(Read read, const std::vector<io::Warning>& forgiven) {
    py::list warnings;
    for (const io::Warning& warning : forgiven)
        warnings.append(py::make_tuple(warning.file, warning.line, warning.message));
    return py::make_tuple(std::move(read), warnings);
}

io::ProblemFile parse(const std::string& text, const std::string& name,
                      const std::filesystem::path& folder, const io::ReadOptions& options) {
    return io::is_scenario(text) ? io::parse_scenario(text, name, folder, options)
                                 : io::parse_problem(text, name, options);
}

io::ReadOptions reading(bool maps_anywhere) {
    io::ReadOptions options;
    options.maps_anywhere = maps_anywhere;
    return options;
}

}  // namespace

void bind_files(py::module_& module) {
    const auto released = py::call_guard<py::gil_scoped_release>();
    module.def(
        "read_problem",
        [](const std::filesystem::path& file, bool maps_anywhere) {
            io::ProblemFile read;
            {
                const py::gil_scoped_release release;
                read = io::read_problem(file, reading(maps_anywhere));
            }
            return with_warnings(std::move(read.problem), read.warnings);
        },
        "file"_a, "maps_anywhere"_a, "(problem, [(file, line, message), ...]).");
    module.def(
        "parse_problem",
        [](const std::string& text, const std::string& name, const std::filesystem::path& folder,
           bool maps_anywhere) {
            io::ProblemFile read = parse(text, name, folder, reading(maps_anywhere));
            return with_warnings(std::move(read.problem), read.warnings);
        },
        "text"_a, "name"_a, "folder"_a, "maps_anywhere"_a, "The same from text of either format.");
    module.def("write_problem", &io::write_problem, released, "file"_a, "problem"_a,
               "Writes the classic format.");
    module.def(
        "read_solution",
        [](const std::filesystem::path& file, std::size_t asv_count) {
            std::vector<io::Warning> warnings;
            core::Solution solution = [&] {
                const py::gil_scoped_release release;
                return io::read_solution(file, asv_count, &warnings);
            }();
            return with_warnings(std::move(solution), warnings);
        },
        "file"_a, "asv_count"_a, "(solution, [(file, line, message), ...]).");
    module.def("write_solution", &io::write_solution, released, "file"_a, "solution"_a,
               "Writes a solution file, whole or not at all. Raises WriteError.");
}

}  // namespace asv::python
