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

void DualActiveSet::clear() {
    rows_.clear();
    limits_.clear();
    compliances_.clear();
    gram_ready_ = false;
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

void DualActiveSet::build_gram() {
    const std::size_t count = size();
    gram_.resize(count * count);
    for (std::size_t r = 0; r < count; ++r) {
        const double* row = rows_.data() + r * dimension_;
        for (std::size_t other = 0; other <= r; ++other)
            gram_[r * count + other] = gram_[other * count + r] =
                dot(row, rows_.data() + other * dimension_, dimension_);
        gram_[r * count + r] += compliances_[r];
    }
    gram_ready_ = true;
}

std::span<const double> DualActiveSet::solve(std::span<const double> wish) {
    const std::size_t count = size();
    if (!gram_ready_) build_gram();
    missing_.resize(count);
    multipliers_.assign(count, 0.0);
    factor_.resize(count * count);
    forward_.resize(count);
    direction_.resize(count);
    active_.clear();
    for (std::size_t r = 0; r < count; ++r)
        missing_[r] = limits_[r] - dot(rows_.data() + r * dimension_, wish.data(), dimension_);
    double wish_square = 0;
    for (double w : wish) wish_square += w * w;
    const double met = accuracy * std::sqrt(std::max(wish_square, 1e-12));

    bool consistent = true;
    for (std::size_t r = 0; r < count; ++r)
        if (compliances_[r] > 0) activate(r);
    for (std::size_t step = 0; consistent && step < 4 * count; ++step) {
        std::size_t worst = count;
        double most = met;
        for (std::size_t r = 0; r < count; ++r) {
            if (compliances_[r] == 0 && missing_[r] > most) {
                most = missing_[r];
                worst = r;
            }
        }
        if (worst == count) break;
        consistent = activate(worst);
    }

    std::copy(wish.begin(), wish.end(), step_.begin());
    pushed_ = false;
    for (const std::size_t r : active_) {
        pushed_ = pushed_ || compliances_[r] == 0;
        const double* row = rows_.data() + r * dimension_;
        for (std::size_t i = 0; i < dimension_; ++i) step_[i] += multipliers_[r] * row[i];
    }
    return step_;
}

/// Fills direction_ with how the active multipliers give way to a unit of the row's own, and
/// returns the square of the part of its gradient that the active ones do not span.
double DualActiveSet::prepare_direction(std::size_t row) {
    const std::size_t count = size(), active = active_.size();
    double square = gram_[row * count + row];
    for (std::size_t i = 0; i < active; ++i) {
        double value = gram_[row * count + active_[i]];
        for (std::size_t k = 0; k < i; ++k) value -= factor_[i * count + k] * forward_[k];
        forward_[i] = value / factor_[i * count + i];
        square -= forward_[i] * forward_[i];
    }
    for (std::size_t i = active; i-- > 0;) {
        double value = forward_[i];
        for (std::size_t k = i + 1; k < active; ++k)
            value -= factor_[k * count + i] * direction_[k];
        direction_[i] = value / factor_[i * count + i];
    }
    return square;
}

/// Makes the row active, taking out rows that would have to pull; false when it contradicts the
/// active ones.
bool DualActiveSet::activate(std::size_t row) {
    const std::size_t count = size();
    while (true) {
        const double square = prepare_direction(row);
        const bool spanned = square <= dependent * gram_[row * count + row];
        double length = spanned ? std::numeric_limits<double>::infinity() : missing_[row] / square;
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
        multipliers_[row] += length;
        for (std::size_t other = 0; other < count; ++other) {
            double change = gram_[row * count + other];
            for (std::size_t i = 0; i < active_.size(); ++i)
                change -= direction_[i] * gram_[active_[i] * count + other];
            missing_[other] -= length * change;
        }
        for (std::size_t i = 0; i < active_.size(); ++i)
            multipliers_[active_[i]] -= length * direction_[i];
        if (leaving == active_.size()) {
            const std::size_t position = active_.size();
            for (std::size_t k = 0; k < position; ++k) factor_[position * count + k] = forward_[k];
            factor_[position * count + position] = std::sqrt(square);
            active_.push_back(row);
            return true;
        }
        multipliers_[active_[leaving]] = 0;
        deactivate(leaving);
    }
}

void DualActiveSet::deactivate(std::size_t position) {
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(position));
    const std::size_t count = size();
    for (std::size_t i = position; i < active_.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double value = gram_[active_[i] * count + active_[k]];
            for (std::size_t j = 0; j < k; ++j)
                value -= factor_[i * count + j] * factor_[k * count + j];
            factor_[i * count + k] =
                k == i ? std::sqrt(std::max(value, 1e-300)) : value / factor_[k * count + k];
        }
    }
}

}  // namespace asv::core
