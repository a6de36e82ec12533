#include "tools/python/binding/support/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace asv::python {

namespace {

using geometry::Box;
using geometry::Point;

// What an array of doubles can be laid over.
static_assert(sizeof(Point) == 2 * sizeof(double) && sizeof(Box) == 4 * sizeof(double));

void require_finite(const Array& array, const char* what) {
    const auto finite = [](double number) { return std::isfinite(number); };
    if (!std::all_of(array.data(), array.data() + array.size(), finite))
        throw std::invalid_argument(std::string(what) + ": every number has to be finite");
}

py::array read_only(const double* numbers, std::vector<py::ssize_t> shape, py::handle owner) {
    py::array_t<double> array(std::move(shape), numbers, owner);
    array.attr("flags").attr("writeable") = false;
    return array;
}

}  // namespace

std::vector<Point> to_points(const Array& array, const char* what) {
    if (array.ndim() != 2 || array.shape(1) != 2)
        throw std::invalid_argument(std::string(what) + ": expected points, an array n x 2");
    require_finite(array, what);
    std::vector<Point> points;
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        points.push_back({array.at(i, 0), array.at(i, 1)});
    return points;
}

std::vector<Box> to_boxes(const Array& array, const char* what) {
    if (array.size() == 0) return {};
    const bool flat = array.ndim() == 2 && array.shape(1) == 4;
    const bool corners = array.ndim() == 3 && array.shape(1) == 2 && array.shape(2) == 2;
    if (!flat && !corners)
        throw std::invalid_argument(std::string(what) +
                                    ": expected boxes, an array m x 4 (low x, low y, high x, high "
                                    "y) or m x 2 x 2 (low corner, high corner)");
    require_finite(array, what);
    std::vector<Box> boxes;
    for (const double* at = array.data(); at != array.data() + array.size(); at += 4) {
        boxes.push_back({{at[0], at[1]}, {at[2], at[3]}});
        if (is_empty(boxes.back()))
            throw std::invalid_argument(std::string(what) + ": box " +
                                        std::to_string(boxes.size() - 1) +
                                        " has its high corner below its low one");
    }
    return boxes;
}

py::array view(std::span<const Point> points, std::vector<py::ssize_t> shape, py::handle owner) {
    return read_only(points.empty() ? nullptr : &points.front().x, std::move(shape), owner);
}

py::array view(std::span<const Box> boxes, py::handle owner) {
    const auto count = static_cast<py::ssize_t>(boxes.size());
    return read_only(boxes.empty() ? nullptr : &boxes.front().low.x, {count, 2, 2}, owner);
}

py::array copy(std::span<const double> numbers, std::vector<py::ssize_t> shape) {
    return py::array_t<double>(std::move(shape), numbers.data());
}

}  // namespace asv::python
