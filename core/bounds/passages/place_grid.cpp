#include "core/bounds/passages/place_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/boxes/span.hpp"

namespace asv::core {

namespace {

using geometry::Span;

std::vector<double> cuts(const Span& bounds, std::span<const Span> boxes, double longest) {
    std::vector<double> sides{bounds.low, bounds.high};
    for (const Span& box : boxes)
        for (const double side : {box.low, box.high})
            if (side > bounds.low && side < bounds.high) sides.push_back(side);
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const double length = sides[i + 1] - sides[i];
        const double parts = std::max(1.0, std::ceil(length / longest));
        for (double part = 0; part < parts; ++part) all.push_back(sides[i] + length * part / parts);
    }
    all.push_back(sides.back());
    return all;
}

/// Which part between two cuts holds the value.
std::size_t part_of(const std::vector<double>& cuts, double value) {
    const auto inner_end = cuts.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(cuts.begin() + 1, inner_end, value) -
                                    (cuts.begin() + 1));
}

}  // namespace

PlaceGrid::PlaceGrid(const geometry::Box& bounds, std::span<const geometry::Box> boxes,
                     double longest) {
    std::vector<Span> x, y;
    for (const geometry::Box& box : boxes) {
        x.push_back(x_span(box));
        y.push_back(y_span(box));
    }
    xs_ = cuts(x_span(bounds), x, longest);
    ys_ = cuts(y_span(bounds), y, longest);
}

geometry::Box PlaceGrid::box(std::size_t place) const {
    const std::size_t column = place / rows(), row = place % rows();
    return {{xs_[column], ys_[row]}, {xs_[column + 1], ys_[row + 1]}};
}

std::size_t PlaceGrid::place_at(const geometry::Point& point) const {
    return part_of(xs_, point.x) * rows() + part_of(ys_, point.y);
}

std::vector<std::size_t> PlaceGrid::neighbours(std::size_t place) const {
    const std::size_t column = place / rows(), row = place % rows();
    std::vector<std::size_t> beside;
    if (column > 0) beside.push_back(place - rows());
    if (column + 1 < columns()) beside.push_back(place + rows());
    if (row > 0) beside.push_back(place - 1);
    if (row + 1 < rows()) beside.push_back(place + 1);
    return beside;
}

}  // namespace asv::core
