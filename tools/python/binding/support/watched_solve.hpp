#pragma once

#include <pybind11/pybind11.h>

#include "core/solve/solve.hpp"

namespace asv::python {

namespace py = pybind11;

/// Solves on a thread of its own, which never touches Python, while the calling thread looks after
/// signals, progress and the wish to stop; between looks it gives the interpreter to others.
///
/// on_progress: called with each news of the work, or None. should_stop: a function that is asked
/// some fifty times a second whether to end early and keep the best so far, or None. What either
/// raises, and KeyboardInterrupt, ends the work and is thrown.
core::SolveResult solve_watched(const core::Problem& problem, core::SolveOptions options,
                                const py::object& on_progress, const py::object& should_stop);

}  // namespace asv::python
