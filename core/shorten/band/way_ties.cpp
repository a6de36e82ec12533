#include "core/shorten/band/way_ties.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

WayTies::WayTies(const Chain& chain)
    : chain_(chain),
      stiffness_(chain.asv_count()),
      behind_(chain.broom_count()),
      pull_x_(chain.asv_count()),
      pull_y_(chain.asv_count()) {}

void WayTies::tie(std::span<const Pose> poses, double softening, double damping,
                  BlockTridiagonal& system, std::span<double> force) {
    const std::size_t inner = poses.size() - 2, d = chain_.dimension();
    system.reset(inner, d);
    std::fill(force.begin(), force.end(), 0.0);
    for (std::size_t motion = 0; motion <= inner; ++motion) {
        const Pose &a = poses[motion], &b = poses[motion + 1];
        for (std::size_t j = 0; j < stiffness_.size(); ++j) {
            const double dx = b.x[j] - a.x[j], dy = b.y[j] - a.y[j];
            stiffness_[j] = 1 / std::sqrt(dx * dx + dy * dy + softening * softening);
            pull_x_[j] = stiffness_[j] * dx;
            pull_y_[j] = stiffness_[j] * dy;
        }
        if (motion > 0) {
            add_stiffness(a, a, 1, system.diagonal(motion - 1));
            add_force(a, 1, force.subspan((motion - 1) * d, d));
        }
        if (motion < inner) {
            add_stiffness(b, b, 1, system.diagonal(motion));
            add_force(b, -1, force.subspan(motion * d, d));
        }
        if (motion > 0 && motion < inner) add_stiffness(a, b, -1, system.upper(motion - 1));
    }
    std::fill(stiffness_.begin(), stiffness_.end(), damping);
    for (std::size_t i = 0; i < inner; ++i)
        add_stiffness(poses[i + 1], poses[i + 1], 1, system.diagonal(i));
}

/// Adds sign * A' K B, where A and B hold the derivatives of the ASVs' positions at two poses and K
/// the stiffness of each ASV. An ASV follows the brooms before it in the chain, so that sums over
/// the ASVs behind a broom are all that is needed: O(n^2).
void WayTies::add_stiffness(const Pose& a, const Pose& b, double sign, std::span<double> block) {
    const std::size_t d = chain_.dimension(), brooms = chain_.broom_count();
    const auto anchor = chain_.anchor_lever();
    const double length = chain_.broom_length();
    double all = 0;
    for (std::size_t j = stiffness_.size(); j-- > 0;) {
        all += stiffness_[j];
        if (j > 0) behind_[j - 1] = all;
    }
    block[0] += sign * all;
    block[d + 1] += sign * all;
    for (std::size_t k = 0; k < brooms; ++k) {
        const double along = sign * length * (behind_[k] + anchor[k] * all);
        block[2 + k] -= along * a.uy[k];
        block[d + 2 + k] += along * a.ux[k];
        block[(2 + k) * d] -= along * b.uy[k];
        block[(2 + k) * d + 1] += along * b.ux[k];
    }
    const double square = sign * length * length;
    for (std::size_t l = 0; l < brooms; ++l)
        for (std::size_t k = 0; k < brooms; ++k) {
            const double both = behind_[std::max(k, l)] + anchor[k] * behind_[l] +
                                anchor[l] * behind_[k] + anchor[k] * anchor[l] * all;
            block[(2 + l) * d + 2 + k] += square * both * (a.ux[k] * b.ux[l] + a.uy[k] * b.uy[l]);
        }
}

/// Adds sign times the pull on the ASVs, as it acts on the heading coordinates of the pose.
void WayTies::add_force(const Pose& pose, double sign, std::span<double> force) const {
    const double length = sign * chain_.broom_length();
    double x = 0, y = 0;
    for (std::size_t j = pose.x.size(); j-- > 0;) {
        x += pull_x_[j];
        y += pull_y_[j];
        if (j > 0) force[1 + j] += length * (pose.ux[j - 1] * y - pose.uy[j - 1] * x);
    }
    force[0] += sign * x;
    force[1] += sign * y;
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        force[2 + k] += length * chain_.anchor_lever()[k] * (pose.ux[k] * y - pose.uy[k] * x);
}

}  // namespace asv::core
