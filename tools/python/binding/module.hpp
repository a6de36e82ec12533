#pragma once

#include <pybind11/pybind11.h>

/// One function for each topic, each in a file of its name.

namespace asv::python {

namespace py = pybind11;

void bind_errors();
void bind_problem(py::module_& module);
void bind_files(py::module_& module);
void bind_planners(py::module_& module);
void bind_validate(py::module_& module);
void bind_solve(py::module_& module);
void bind_generate(py::module_& module);
void bind_draw(py::module_& module);
void bind_space(py::module_& module);

}  // namespace asv::python
