#include "core/space/steering/dual_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace asv::core {

namespace {

/// A row counts as met when it lacks less than this share of the wished step.
constexpr double accuracy = 1e-6;
/// A row whose part across the active ones is smaller than this (squared) depends on them.
constexpr double dependent = 1e-10;

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;
using ConstRows =
    Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

Eigen::Index signed_size(std::size_t size) {
    return static_cast<Eigen::Index>(size);
}

ConstVector vector_of(std::span<const double> values) {
    return {values.data(), signed_size(values.size())};
}

Vector vector_of(std::vector<double>& values) {
    return {values.data(), signed_size(values.size())};
}

}  // namespace

DualActiveSet::DualActiveSet(std::size_t dimension)
    : dimension_(dimension), wish_(dimension), step_(dimension), change_(dimension) {}

void DualActiveSet::clear() {
    rows_.clear();
    limits_.clear();
    compliances_.clear();
    active_.clear();
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
    std::copy(wish.begin(), wish.end(), wish_.begin());
    step_ = wish_;
    multipliers_.assign(size(), 0.0);
    active_.clear();
    // Active rows are independent but for the springs, which their compliance makes so.
    const auto springs = static_cast<std::size_t>(
        std::count_if(compliances_.begin(), compliances_.end(), [](double c) { return c > 0; }));
    stride_ = dimension_ + springs;
    factor_.resize(stride_ * stride_);
    for (std::size_t r = 0; r < size(); ++r)
        if (compliances_[r] > 0) activate(r);
    return add_violated();
}

std::span<const double> DualActiveSet::solve_again() {
    solve_active();
    while (const auto pulling = strongest_pulling_row()) {
        multipliers_[active_[*pulling]] = 0;
        deactivate(*pulling);
        solve_active();
    }
    step_ = wish_;
    for (const std::size_t active : active_)
        vector_of(step_) += multipliers_[active] * vector_of(row(active));
    return add_violated();
}

/// Which active row pulls most where it may only push, if one does.
std::optional<std::size_t> DualActiveSet::strongest_pulling_row() const {
    std::optional<std::size_t> found;
    double least = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
        if (compliances_[active_[i]] > 0 || multipliers_[active_[i]] >= least) continue;
        least = multipliers_[active_[i]];
        found = i;
    }
    return found;
}

/// Makes the row active that lacks most, until none lacks anything.
std::span<const double> DualActiveSet::add_violated() {
    const double met = accuracy * std::sqrt(std::max(vector_of(wish_).squaredNorm(), 1e-12));
    const std::size_t max_steps = 4 * (dimension_ + active_.size()) + 8;
    bool consistent = true;
    for (std::size_t step = 0; consistent && step < max_steps; ++step) {
        find_missing();
        std::size_t worst = size();
        double most = met;
        for (std::size_t r = 0; r < size(); ++r) {
            if (compliances_[r] > 0 || missing_[r] <= most) continue;
            most = missing_[r];
            worst = r;
        }
        if (worst == size()) break;
        consistent = activate(worst);
    }
    pushed_ = std::any_of(active_.begin(), active_.end(),
                          [this](std::size_t r) { return compliances_[r] == 0; });
    return {step_.data(), dimension_};
}

void DualActiveSet::find_missing() {
    missing_.assign(limits_.begin(), limits_.end());
    const ConstRows rows(rows_.data(), signed_size(size()), signed_size(dimension_));
    vector_of(missing_).noalias() -= rows * vector_of(step_);
}

double DualActiveSet::gram(std::size_t a, std::size_t b) const {
    return vector_of(row(a)).dot(vector_of(row(b))) + (a == b ? compliances_[a] : 0);
}

/// Fills direction_ with how the active multipliers give way to a unit of the row's own, and
/// returns the square of the part of its gradient that the active ones do not span.
double DualActiveSet::prepare_direction(std::size_t row) {
    direction_.resize(active_.size());
    for (std::size_t i = 0; i < active_.size(); ++i) direction_[i] = gram(row, active_[i]);
    substitute_forward(direction_);
    forward_ = direction_;
    const double square = gram(row, row) - vector_of(forward_).squaredNorm();
    substitute_back(direction_);
    return square;
}

/// Solves for the lower factor, in place.
void DualActiveSet::substitute_forward(std::vector<double>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double* row = factor_.data() + i * stride_;
        values[i] -= vector_of({row, i}).dot(vector_of({values.data(), i}));
        values[i] /= row[i];
    }
}

/// Solves for its transpose, in place: row by row, as the factor lies in memory.
void DualActiveSet::substitute_back(std::vector<double>& values) const {
    for (std::size_t i = values.size(); i-- > 0;) {
        const double* row = factor_.data() + i * stride_;
        values[i] /= row[i];
        Vector(values.data(), signed_size(i)) -= values[i] * vector_of({row, i});
    }
}

/// Makes the row active, taking out rows that would have to pull; false when it contradicts the
/// active ones.
bool DualActiveSet::activate(std::size_t added) {
    const double own = gram(added, added);
    while (true) {
        const double square = prepare_direction(added);
        const bool spanned = square <= dependent * own || active_.size() == stride_;
        const double missing = limits_[added] - vector_of(row(added)).dot(vector_of(step_)) -
                               compliances_[added] * multipliers_[added];
        double length = spanned ? std::numeric_limits<double>::infinity() : missing / square;
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
        vector_of(change_) = vector_of(row(added));
        multipliers_[added] += length;
        for (std::size_t i = 0; i < active_.size(); ++i) {
            vector_of(change_) -= direction_[i] * vector_of(row(active_[i]));
            multipliers_[active_[i]] -= length * direction_[i];
        }
        vector_of(step_) += length * vector_of(change_);
        if (leaving == active_.size()) {
            for (std::size_t i = 0; i < active_.size(); ++i)
                factor(active_.size(), i) = forward_[i];
            factor(active_.size(), active_.size()) = std::sqrt(square);
            active_.push_back(added);
            return true;
        }
        multipliers_[active_[leaving]] = 0;
        deactivate(leaving);
    }
}

/// Takes out an active row. The rows of the factor behind it reach one column too far then; Givens
/// rotations of neighbouring columns turn them back into a triangle.
void DualActiveSet::deactivate(std::size_t position) {
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(position));
    for (std::size_t i = position; i < active_.size(); ++i)
        for (std::size_t k = 0; k <= i + 1; ++k) factor(i, k) = factor(i + 1, k);
    for (std::size_t k = position; k < active_.size(); ++k) {
        const double a = factor(k, k), b = factor(k, k + 1);
        const double length = std::sqrt(a * a + b * b);
        const double cosine = a / length, sine = b / length;
        for (std::size_t i = k; i < active_.size(); ++i) {
            const double left = factor(i, k), right = factor(i, k + 1);
            factor(i, k) = cosine * left + sine * right;
            factor(i, k + 1) = cosine * right - sine * left;
        }
    }
}

/// The multipliers with which the active rows, and no others, meet their limits.
void DualActiveSet::solve_active() {
    direction_.resize(active_.size());
    for (std::size_t i = 0; i < active_.size(); ++i)
        direction_[i] = limits_[active_[i]] - vector_of(row(active_[i])).dot(vector_of(wish_));
    substitute_forward(direction_);
    substitute_back(direction_);
    for (std::size_t i = 0; i < active_.size(); ++i) multipliers_[active_[i]] = direction_[i];
}

}  // namespace asv::core
