#include "asv/core/path/shorten.hpp"

#include <algorithm>

namespace asv::core {

namespace {

/// A gain below this share of the path's cost is not worth a more broken path.
constexpr double least_gain = 1e-5;

}  // namespace

Shortcutter::Shortcutter(const Chain& chain, Rows path)
    : dimension_(chain.dimension()),
      motion_cost_(chain),
      path_(std::move(path)),
      from_(dimension_),
      to_(dimension_) {
    measure();
}

void Shortcutter::measure() {
    const std::size_t d = dimension_;
    cumulative_.assign(1, 0.0);
    for (std::size_t i = d; i < path_.size(); i += d)
        cumulative_.push_back(cumulative_.back() +
                              motion_cost_({path_.data() + i - d, d}, {path_.data() + i, d}));
}

Shortcutter::Place Shortcutter::at(double cost) const {
    const auto next = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, cost);
    const auto after = static_cast<std::size_t>(next - cumulative_.begin()) - 1;
    const double length = cumulative_[after + 1] - cumulative_[after];
    const double fraction = length > 0 ? (cost - cumulative_[after]) / length : 0;
    return {after, std::clamp(fraction, 0.0, 1.0)};
}

void Shortcutter::configuration(const Place& place, std::vector<double>& row) const {
    const double* a = path_.data() + place.after * dimension_;
    const double* b = a + dimension_;
    for (std::size_t i = 0; i < dimension_; ++i) row[i] = a[i] + place.fraction * (b[i] - a[i]);
}

bool Shortcutter::attempt(const Bridge& bridge, double most_share, Rng& rng) {
    if (cost() <= 0) return false;
    const double length = most_share * cost() * rng.uniform();
    const double begin = rng.uniform(-0.5 * length, cost() - 0.5 * length);
    const double end = std::min(begin + length, cost());
    const Place first = at(std::max(begin, 0.0)), last = at(end);
    if (first.after == last.after) return false;
    const bool from_start = begin <= 0, to_goal = end >= cost();
    configuration(first, from_);
    configuration(last, to_);
    if (from_start) std::copy_n(path_.begin(), dimension_, from_.begin());
    if (to_goal)
        std::copy(path_.end() - static_cast<std::ptrdiff_t>(dimension_), path_.end(), to_.begin());
    between_.clear();
    if (!bridge(from_, to_, between_)) return false;
    // Whole motions are compared, since the parts of one need not cost exactly what it costs.
    const std::size_t next = last.after + 1;
    const auto row_at = [&](std::size_t i) {
        return std::span<const double>{path_.data() + i * dimension_, dimension_};
    };
    double renewed = motion_cost_(row_at(first.after), from_) + motion_cost_(to_, row_at(next));
    std::span<const double> previous = from_;
    for (std::size_t i = 0; i < between_.size(); i += dimension_) {
        const std::span<const double> row{between_.data() + i, dimension_};
        renewed += motion_cost_(previous, row);
        previous = row;
    }
    if (renewed > cumulative_[next] - cumulative_[first.after] - least_gain * cost()) return false;

    Rows joined(path_.begin(),
                path_.begin() + static_cast<std::ptrdiff_t>(
                                    (first.after + (first.fraction > 0 ? 1 : 0)) * dimension_));
    if (from_start) joined.clear();
    joined.insert(joined.end(), from_.begin(), from_.end());
    joined.insert(joined.end(), between_.begin(), between_.end());
    if (!to_goal)
        joined.insert(joined.end(), path_.begin() + static_cast<std::ptrdiff_t>(next * dimension_),
                      path_.end());
    path_ = std::move(joined);
    measure();
    return true;
}

}  // namespace asv::core
