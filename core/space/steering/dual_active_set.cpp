#include "asv/core/space/steering/dual_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core {

namespace {

/// A row counts as met when it lacks less than this share of the wished step.
constexpr double accuracy = 1e-6;
/// A row whose part across the active ones is smaller than this (squared) depends on them.
constexpr double dependent = 1e-10;

double dot(const double* a, const double* b, std::size_t count) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

DualActiveSet::DualActiveSet(std::size_t dimension)
    : dimension_(dimension), change_(dimension), step_(dimension) {}

void DualActiveSet::clear() {
    rows_.clear();
    limits_.clear();
    compliances_.clear();
}

std::span<double> DualActiveSet::add_row(double limit, double compliance) {
    limits_.push_back(limit);
    compliances_.push_back(compliance);
    rows_.resize(limits_.size() * dimension_);
    return {rows_.data() + rows_.size() - dimension_, dimension_};
}

void DualActiveSet::drop_row() {
    limits_.pop_back();
    compliances_.pop_back();
    rows_.resize(limits_.size() * dimension_);
}

std::span<const double> DualActiveSet::solve(std::span<const double> wish) {
    const std::size_t count = size();
    std::copy(wish.begin(), wish.end(), step_.begin());
    multipliers_.assign(count, 0.0);
    active_.clear();
    const double met =
        accuracy * std::sqrt(std::max(dot(wish.data(), wish.data(), dimension_), 1e-12));

    bool consistent = true;
    for (std::size_t r = 0; r < count; ++r)
        if (compliances_[r] > 0) activate(r);
    const std::size_t most_steps = 4 * (dimension_ + active_.size()) + 8;
    for (std::size_t step = 0; consistent && step < most_steps; ++step) {
        std::size_t worst = count;
        double most = met;
        for (std::size_t r = 0; r < count; ++r) {
            if (compliances_[r] > 0) continue;
            const double lacks = missing(r);
            if (lacks > most) {
                most = lacks;
                worst = r;
            }
        }
        if (worst == count) break;
        consistent = activate(worst);
    }
    pushed_ = std::any_of(active_.begin(), active_.end(),
                          [this](std::size_t r) { return compliances_[r] == 0; });
    return step_;
}

/// What the row lacks at the current point.
double DualActiveSet::missing(std::size_t row) const {
    return limits_[row] - dot(gradient(row), step_.data(), dimension_) -
           compliances_[row] * multipliers_[row];
}

double DualActiveSet::gram(std::size_t a, std::size_t b) const {
    return dot(gradient(a), gradient(b), dimension_) + (a == b ? compliances_[a] : 0);
}

/// Fills direction_ with how the active multipliers give way to a unit of the row's own, and
/// returns the square of the part of its gradient that the active ones do not span.
double DualActiveSet::prepare_direction(std::size_t row) {
    const std::size_t active = active_.size();
    forward_.resize(active);
    direction_.resize(active);
    double square = gram(row, row);
    for (std::size_t i = 0; i < active; ++i) {
        double value = gram(row, active_[i]);
        for (std::size_t k = 0; k < i; ++k) value -= factor(i, k) * forward_[k];
        forward_[i] = value / factor(i, i);
        square -= forward_[i] * forward_[i];
    }
    for (std::size_t i = active; i-- > 0;) {
        double value = forward_[i];
        for (std::size_t k = i + 1; k < active; ++k) value -= factor(k, i) * direction_[k];
        direction_[i] = value / factor(i, i);
    }
    return square;
}

/// Makes the row active, taking out rows that would have to pull; false when it contradicts the
/// active ones.
bool DualActiveSet::activate(std::size_t row) {
    const double own = gram(row, row);
    while (true) {
        const double square = prepare_direction(row);
        const bool spanned = square <= dependent * own;
        double length = spanned ? std::numeric_limits<double>::infinity() : missing(row) / square;
        std::size_t leaving = active_.size();
        for (std::size_t i = 0; i < active_.size(); ++i) {
            if (compliances_[active_[i]] > 0 || direction_[i] <= 0) continue;
            const double until = multipliers_[active_[i]] / direction_[i];
            if (until < length) {
                length = until;
                leaving = i;
            }
        }
        if (!std::isfinite(length)) return false;
        std::copy_n(gradient(row), dimension_, change_.begin());
        multipliers_[row] += length;
        for (std::size_t i = 0; i < active_.size(); ++i) {
            const double* other = gradient(active_[i]);
            for (std::size_t k = 0; k < dimension_; ++k) change_[k] -= direction_[i] * other[k];
            multipliers_[active_[i]] -= length * direction_[i];
        }
        for (std::size_t k = 0; k < dimension_; ++k) step_[k] += length * change_[k];
        if (leaving == active_.size()) {
            // A row of its own length for each active row: the triangle lies packed.
            factor_.resize(active_.size() * (active_.size() + 1) / 2);
            factor_.insert(factor_.end(), forward_.begin(), forward_.end());
            factor_.push_back(std::sqrt(square));
            active_.push_back(row);
            return true;
        }
        multipliers_[active_[leaving]] = 0;
        deactivate(leaving);
    }
}

void DualActiveSet::deactivate(std::size_t position) {
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(position));
    for (std::size_t i = position; i < active_.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double value = gram(active_[i], active_[k]);
            for (std::size_t j = 0; j < k; ++j) value -= factor(i, j) * factor(k, j);
            factor(i, k) = k == i ? std::sqrt(std::max(value, 1e-300)) : value / factor(k, k);
        }
    }
}

}  // namespace asv::core
