#include "core/shorten/shortcutter.hpp"

#include <algorithm>

namespace asv::core {

namespace {

/// A gain below this share of the path's cost is not worth a more broken path.
constexpr double min_shortcut_gain = 1e-5;

}  // namespace

Shortcutter::Shortcutter(std::size_t dimension, Cost cost, Configurations path)
    : dimension_(dimension),
      motion_cost_(std::move(cost)),
      path_(std::move(path)),
      from_(dimension_),
      to_(dimension_) {
    measure({}, {});
}

/// Of the motions at the beginning and the end the costs are known; those between are measured.
void Shortcutter::measure(std::span<const double> known_first, std::span<const double> known_last) {
    const std::size_t motions = path_.size() / dimension_ - 1;
    std::vector<double> costs(known_first.begin(), known_first.end());
    while (costs.size() + known_last.size() < motions)
        costs.push_back(motion_cost_(row(costs.size()), row(costs.size() + 1)));
    costs.insert(costs.end(), known_last.begin(), known_last.end());
    costs_ = std::move(costs);
    cumulative_.assign(1, 0.0);
    for (const double cost : costs_) cumulative_.push_back(cumulative_.back() + cost);
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

/// Draws two places; false where they lie on one motion.
bool Shortcutter::choose(double max_share, Rng& rng) {
    if (cost() <= 0) return false;
    const double length = max_share * cost() * rng.uniform();
    const double begin = rng.uniform(-0.5 * length, cost() - 0.5 * length);
    const double end = std::min(begin + length, cost());
    first_ = at(std::max(begin, 0.0));
    last_ = at(end);
    if (first_.after == last_.after) return false;
    from_start_ = begin <= 0;
    to_goal_ = end >= cost();
    configuration(first_, from_);
    configuration(last_, to_);
    if (from_start_) std::copy_n(path_.begin(), dimension_, from_.begin());
    if (to_goal_)
        std::copy(path_.end() - static_cast<std::ptrdiff_t>(dimension_), path_.end(), to_.begin());
    between_.clear();
    return true;
}

/// Does what leads from place to place now cost less than what did? Whole motions are compared,
/// since the parts of one need not cost exactly what it costs.
bool Shortcutter::gains() {
    const std::size_t next = last_.after + 1;
    double renewed = motion_cost_(row(first_.after), from_) + motion_cost_(to_, row(next));
    std::span<const double> previous = from_;
    for (std::size_t i = 0; i < between_.size(); i += dimension_) {
        const std::span<const double> next_row{between_.data() + i, dimension_};
        renewed += motion_cost_(previous, next_row);
        previous = next_row;
    }
    return renewed <= cumulative_[next] - cumulative_[first_.after] - min_shortcut_gain * cost();
}

void Shortcutter::replace() {
    const auto row_begin = [&](std::size_t i) {
        return path_.begin() + static_cast<std::ptrdiff_t>(i * dimension_);
    };
    Configurations joined(path_.begin(), row_begin(first_.after + (first_.fraction > 0 ? 1 : 0)));
    if (from_start_) joined.clear();
    joined.insert(joined.end(), from_.begin(), from_.end());
    joined.insert(joined.end(), between_.begin(), between_.end());
    if (!to_goal_) joined.insert(joined.end(), row_begin(last_.after + 1), path_.end());
    path_ = std::move(joined);
    const std::span<const double> before(costs_);
    measure(before.first(from_start_ ? 0 : first_.after),
            before.last(to_goal_ ? 0 : before.size() - (last_.after + 1)));
}

bool Shortcutter::attempt(const Bridge& bridge, double max_share, Rng& rng) {
    if (!choose(max_share, rng) || !bridge(from_, to_, between_) || !gains()) return false;
    replace();
    return true;
}

bool Shortcutter::attempt_partial(std::size_t first, std::size_t count, const MotionValid& valid,
                                  double max_share, Rng& rng) {
    if (!choose(max_share, rng)) return false;
    const auto way_at = [&](const Place& place) {
        const double begin = cumulative_[place.after], end = cumulative_[place.after + 1];
        return begin + place.fraction * (end - begin);
    };
    const double begin = way_at(first_), end = way_at(last_);
    for (std::size_t i = first_.after + 1; i <= last_.after; ++i) {
        const double* row = path_.data() + i * dimension_;
        between_.insert(between_.end(), row, row + dimension_);
        const double t = (cumulative_[i] - begin) / (end - begin);
        for (std::size_t k = first; k < first + count; ++k)
            between_[between_.size() - dimension_ + k] = from_[k] + t * (to_[k] - from_[k]);
    }
    between_.insert(between_.end(), to_.begin(), to_.end());
    if (!gains()) return false;
    std::span<const double> previous = from_;
    for (std::size_t i = 0; i < between_.size(); i += dimension_) {
        const std::span<const double> next_row{between_.data() + i, dimension_};
        if (!valid(previous, next_row)) return false;
        previous = next_row;
    }
    replace();
    return true;
}

}  // namespace asv::core
