#include "tools/python/binding/module.hpp"

#include "geometry/simd/instruction_set.hpp"

/// The compiled part of the Python package asv. Whatever reads better in Python is in
/// tools/python/asv.
PYBIND11_MODULE(_core, module) {
    module.doc() = "The compiled part of the package asv: use what asv itself exports.";
    asv::geometry::simd::use_instruction_set_of_environment();  // else an ImportError
    module.attr("__version__") = ASV_VERSION;
    asv::python::bind_errors();
    asv::python::bind_problem(module);
    asv::python::bind_files(module);
    asv::python::bind_planners(module);
    asv::python::bind_validate(module);
    asv::python::bind_draw(module);
    asv::python::bind_solve(module);
    asv::python::bind_generate(module);
    asv::python::bind_space(module);
}
