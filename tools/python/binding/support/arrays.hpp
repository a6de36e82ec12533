#pragma once

#include <span>
#include <vector>

#include <pybind11/numpy.h>

#include "core/model/problem.hpp"

/// Points and boxes as numpy arrays. All that go in may be any nested sequence of numbers.

namespace asv::python {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The points of an n x 2 array. Throws std::invalid_argument, which names `what`, for another
/// shape or a number that is not finite.
std::vector<geometry::Point> to_points(const Array& array, const char* what);

/// The boxes of an m x 4 array (low x, low y, high x, high y) or of an m x 2 x 2 one (low corner,
/// high corner); none of an empty one. Throws likewise, also for a box that is empty.
std::vector<geometry::Box> to_boxes(const Array& array, const char* what);

/// Points as a read-only array of the given shape, whose last length is 2. Nothing is copied: the
/// owner, in whose memory the points are, lives as long as the array.
py::array view(std::span<const geometry::Point> points, std::vector<py::ssize_t> shape,
               py::handle owner);

/// Boxes as a read-only m x 2 x 2 array in the owner's memory.
py::array view(std::span<const geometry::Box> boxes, py::handle owner);

/// Numbers as an array of its own, of the given shape.
py::array copy(std::span<const double> numbers, std::vector<py::ssize_t> shape);

}  // namespace asv::python
