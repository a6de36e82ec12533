#include "tools/python/binding/support/python_space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "core/search/trees/interpolate.hpp"
#include "tools/python/binding/support/arrays.hpp"

namespace asv::python {

namespace {

using core::Steered;
using Row = std::span<const double>;

/// A share of the longest side that a stride has where the space names none: walls thinner than a
/// fiftieth of the field are rare, and motion_valid() judges the whole stride anyway.
constexpr double default_stride = 0.02;

py::object method(const py::object& space, const char* name) {
    return py::getattr(space, name, py::none());
}

py::object needed_method(const py::object& space, const char* name) {
    if (!py::hasattr(space, name))
        throw py::type_error(std::string("the space needs a method ") + name + "()");
    return space.attr(name);
}

std::vector<double> numbers(const py::object& space, const char* name, std::size_t dimension) {
    const py::object given = method(space, name);
    if (given.is_none()) return {};
    auto list = given.cast<std::vector<double>>();
    if (list.size() != dimension)
        throw std::invalid_argument(std::string("the space's ") + name + " has " +
                                    std::to_string(list.size()) + " numbers, start and goal have " +
                                    std::to_string(dimension));
    return list;
}

py::array array_of(Row row) {
    return copy(row, {static_cast<py::ssize_t>(row.size())});
}

}  // namespace

PythonSpace::PythonSpace(py::object space, std::size_t dimension)
    : sample_(needed_method(space, "sample")),
      distance_(method(space, "distance")),
      motion_valid_(needed_method(space, "motion_valid")),
      valid_(method(space, "valid")),
      cost_(method(space, "cost")),
      scales_(numbers(space, "scales", dimension)),
      low_(numbers(space, "low", dimension)),
      high_(numbers(space, "high", dimension)) {
    if (scales_.empty()) scales_.assign(dimension, 1.0);
    if (low_.empty() != high_.empty())
        throw std::invalid_argument("the space needs both low and high, or neither");
    const py::object angles = method(space, "wrapping");
    if (!angles.is_none()) {
        const auto [first, count] = angles.cast<std::pair<std::size_t, std::size_t>>();
        if (first > dimension || count > dimension - first)
            throw std::invalid_argument("the space's wrapping (first, count) leaves the dimension");
        wrapping_ = {first, count};
    }
    const py::object stride = method(space, "stride");
    if (!stride.is_none()) {
        stride_ = stride.cast<double>();
    } else {
        for (std::size_t i = 0; i < low_.size(); ++i)
            stride_ = std::max(stride_, default_stride * extent(i));
    }
}

bool PythonSpace::sample(core::Rng& rng, std::span<double> out) {
    const py::object drawn = sample_(py::cast(&rng, py::return_value_policy::reference));
    if (drawn.is_none()) return false;
    const auto row = drawn.cast<std::vector<double>>();
    if (row.size() != out.size())
        throw std::invalid_argument("sample() returned " + std::to_string(row.size()) +
                                    " numbers, start and goal have " + std::to_string(out.size()));
    std::copy(row.begin(), row.end(), out.begin());
    return true;
}

double PythonSpace::distance(Row a, Row b) const {
    if (!distance_.is_none()) return distance_(array_of(a), array_of(b)).cast<double>();
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = scales_[i] * (a[i] - b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

bool PythonSpace::motion_valid(Row from, Row to) const {
    return py::bool_(motion_valid_(array_of(from), array_of(to)));
}

bool PythonSpace::valid(Row row) const {
    for (std::size_t i = 0; i < low_.size(); ++i)
        if (!wrapping_.contains(i) && (row[i] < low_[i] || row[i] > high_[i])) return false;
    if (valid_.is_none()) return motion_valid(row, row);
    return py::bool_(valid_(array_of(row)));
}

Steered PythonSpace::steer(Row from, Row target, core::Configurations& visited) const {
    if (!(stride_ > 0))
        throw std::invalid_argument("rrt-connect needs a stride above 0, or low and high");
    std::vector<double> at(from.begin(), from.end()), next(from.size());
    auto outcome = Steered::trapped;
    while (outcome != Steered::reached) {
        const double left = distance(at, target);
        const bool last = left <= stride_;
        if (last)
            std::copy(target.begin(), target.end(), next.begin());
        else
            core::interpolate(at, target, stride_ / left, next);
        if (!motion_valid(at, next)) break;
        visited.insert(visited.end(), next.begin(), next.end());
        outcome = last ? Steered::reached : Steered::advanced;
        at = next;
    }
    return outcome;
}

void PythonSpace::require_bounds() const {
    if (low_.empty())
        throw std::invalid_argument(
            "this planner or sampler needs the bounds of the space, low and high");
}

bool PythonSpace::from_unit_cube(Row unit, std::span<double> out) const {
    require_bounds();
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = low_[i] + unit[i] * (high_[i] - low_[i]);
    return true;
}

double PythonSpace::extent(std::size_t coordinate) const {
    require_bounds();
    return scales_[coordinate] * (high_[coordinate] - low_[coordinate]);
}

void PythonSpace::perturb(core::Rng& rng, Row row, double sigma, std::span<double> out) const {
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = row[i] + sigma * rng.normal() / scales_[i];
}

double PythonSpace::cost(Row from, Row to) const {
    if (cost_.is_none()) return distance(from, to);
    return cost_(array_of(from), array_of(to)).cast<double>();
}

/// A cost of one's own may be anything, so that zero alone is sure to be a bound.
double PythonSpace::cost_lower_bound(Row from, Row to) const {
    return cost_.is_none() ? distance(from, to) : 0.0;
}

}  // namespace asv::python
