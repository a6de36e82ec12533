#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <pybind11/pybind11.h>

#include "core/search/configuration_space.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"

namespace asv::python {

namespace py = pybind11;

/// A space that is written in Python, see asv.Space: what the object has is asked of it, what it
/// lacks is derived from that. A SampledSpace, so every planner but `auto` searches in it. The
/// interpreter is held while it is used; what Python raises goes through the planner.
class PythonSpace {
    using Row = std::span<const double>;

  public:
    /// Throws std::invalid_argument when the object's lists are not as long as its dimension.
    PythonSpace(py::object space, std::size_t dimension);

    std::size_t dimension() const { return scales_.size(); }
    core::WrappingAngles wrapping() const { return wrapping_; }
    core::NearestNeighbours make_index() const { return {scales_, wrapping_}; }

    bool sample(core::Rng& rng, std::span<double> out);
    double distance(Row a, Row b) const;
    bool motion_valid(Row from, Row to) const;
    /// In strides, as far as they are valid.
    core::Steered steer(Row from, Row target, core::Configurations& visited) const;

    bool from_unit_cube(Row unit, std::span<double> out) const;
    double extent(std::size_t coordinate) const;
    void perturb(core::Rng& rng, Row row, double sigma, std::span<double> out) const;
    bool collides(Row row) const { return !valid(row); }
    bool valid(Row row) const;
    double cost(Row from, Row to) const;
    double cost_lower_bound(Row from, Row to) const;

  private:
    void require_bounds() const;

    py::object sample_, distance_, motion_valid_, valid_, cost_;  ///< methods; None: not there
    std::vector<double> scales_, low_, high_;  ///< low and high may be empty: no bounds
    core::WrappingAngles wrapping_;
    double stride_ = 0;  ///< in the metric
};

static_assert(core::SampledSpace<PythonSpace>);

}  // namespace asv::python
