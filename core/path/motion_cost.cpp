#include "asv/core/path/motion_cost.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asv::core {

namespace {

/// A chord over an arc of this angle, radians, is 0.1 % shorter than the arc.
constexpr double arc = 0.16;

}  // namespace

MotionCost::MotionCost(const Chain& chain)
    : chain_(chain), pose_(chain.make_pose()), next_(chain.make_pose()), row_(chain.dimension()) {}

double MotionCost::operator()(std::span<const double> from, std::span<const double> to) {
    chain_.forward(from, pose_);
    chain_.forward(to, next_);
    double most = 0;
    for (std::size_t k = 0; k < pose_.heading.size(); ++k)
        most = std::max(most, std::abs(next_.heading[k] - pose_.heading[k]));
    const auto pieces = static_cast<std::size_t>(most / arc) + 1;
    double sum = 0;
    for (std::size_t piece = 1; piece <= pieces; ++piece) {
        const double t = static_cast<double>(piece) / static_cast<double>(pieces);
        if (pieces > 1) {
            for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = from[i] + t * (to[i] - from[i]);
            chain_.forward(row_, next_);
        }
        for (std::size_t j = 0; j < pose_.x.size(); ++j) {
            const double dx = next_.x[j] - pose_.x[j], dy = next_.y[j] - pose_.y[j];
            sum += std::sqrt(dx * dx + dy * dy);
        }
        std::swap(pose_, next_);
    }
    return sum;
}

double MotionCost::path(const Rows& rows) {
    const std::size_t d = chain_.dimension();
    double sum = 0;
    for (std::size_t i = d; i < rows.size(); i += d)
        sum += (*this)({rows.data() + i - d, d}, {rows.data() + i, d});
    return sum;
}

}  // namespace asv::core
