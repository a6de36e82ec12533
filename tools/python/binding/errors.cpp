#include <exception>

#include "core/generate/random_chain.hpp"
#include "core/solve/solve.hpp"
#include "io/text/parse_error.hpp"
#include "tools/python/binding/module.hpp"

namespace asv::python {

namespace {

/// Raises the class of that name in asv.errors, made from the arguments.
template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
    const py::object type = py::module_::import("asv.errors").attr(name);
    PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

void raise_invalid_ends(const core::InvalidEnds& error) {
    py::list ends;
    for (const core::InvalidEnd& end : error.ends())
        ends.append(py::make_tuple(end.goal ? "goal" : "start", end.reason));
    raise("InvalidEnds", error.what(), ends);
}

/// The library's own errors; others are left to pybind11: std::invalid_argument is a ValueError.
void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const io::ParseError& error) {
        raise("ParseError", error.what(), error.file(), error.line(), error.column(),
              error.expected(), error.found());
    } catch (const io::ReadError& error) {
        raise("ReadError", error.what());
    } catch (const io::FileError& error) {
        raise("WriteError", error.what());
    } catch (const core::InvalidEnds& error) {
        raise_invalid_ends(error);
    } catch (const core::NoRoom& error) {
        raise("NoRoom", error.what());
    }
}

}  // namespace

void bind_errors() {
    py::register_exception_translator(&translate);
}

}  // namespace asv::python
