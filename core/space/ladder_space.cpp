#include "core/space/ladder_space.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Rounds of straight extension, enlargement and ladder in one call of steer().
constexpr int max_rounds = 40;

std::vector<double> ladder_scales(const Chain& chain, double heading_weight) {
    std::vector<double> scales(chain.dimension(), 0.0);
    scales[0] = scales[1] = 1;
    if (scales.size() > 2) scales[2] = heading_weight;
    return scales;
}

}  // namespace

LadderSpace::LadderSpace(const ChainWorld& world, const LadderOptions& options)
    : world_(world),
      straight_(world, options.widest_corridor),
      options_(options),
      scales_(ladder_scales(world.chain, options.heading_weight)),
      row_(world.chain.dimension()),
      next_(world.chain.dimension()),
      pose_(world.chain.make_pose()),
      other_pose_(world.chain.make_pose()) {}

double LadderSpace::distance(std::span<const double> a, std::span<const double> b) const {
    double sum = 0;
    for (std::size_t i = 0; i < scales_.size(); ++i)
        sum += scales_[i] * scales_[i] * (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

/// Stepwise sampling with the range of angles lifted for a while when it fails too often.
bool LadderSpace::sample(Rng& rng, std::span<double> row) {
    const bool lifted = !options_.limit_angles || lifted_left_ > 0;
    if (lifted_left_ > 0) --lifted_left_;
    if (draw(rng, lifted, row)) {
        failures_ = 0;
        return true;
    }
    if (++failures_ >= options_.lift_after && lifted_left_ == 0) {
        lifted_left_ = options_.lifted_for;
        failures_ = 0;
    }
    return false;
}

bool LadderSpace::draw(Rng& rng, bool any_turn, std::span<double> row) {
    using From = StepwiseSampler::From;
    StepwiseSampler& stepwise = straight_.stepwise();
    const bool use[] = {options_.stepwise, options_.corridor, options_.corridor_reversed};
    const auto count = static_cast<std::size_t>(std::count(std::begin(use), std::end(use), true));
    if (count == 0) return stepwise.sample(rng, From::first_asv, std::nullopt, any_turn, row);
    std::size_t chosen = rng.below(count), kind = 0;
    while (!use[kind] || chosen-- > 0) ++kind;
    if (kind == 0) return stepwise.sample(rng, From::first_asv, std::nullopt, any_turn, row);
    return stepwise.sample(rng, kind == 1 ? From::first_asv : From::last_asv,
                           straight_.corridors().sample(rng), any_turn, row);
}

Steered LadderSpace::steer(std::span<const double> from, std::span<const double> target,
                           Configurations& visited) {
    const std::size_t before = visited.size();
    std::copy(from.begin(), from.end(), row_.begin());
    for (int round = 0; round < max_rounds; ++round) {
        if (go(target, visited)) return Steered::reached;
        if (options_.enlarge && enlarge(target, visited)) continue;
        if (!options_.ladder || !climb_ladder(target, visited)) break;
    }
    return visited.size() > before ? Steered::advanced : Steered::trapped;
}

/// Straight toward the target as far as that is proven; true when it is reached.
bool LadderSpace::go(std::span<const double> target, Configurations& visited) {
    const double proven = straight_.checker().valid_prefix(row_, target, options_.step);
    if (proven < 0) return false;
    for (std::size_t i = 0; i < row_.size(); ++i)
        next_[i] = proven >= 1 ? target[i] : row_[i] + proven * (target[i] - row_[i]);
    if (proven < 1 && farthest_motion(row_, next_) < options_.step) return false;
    visited.insert(visited.end(), next_.begin(), next_.end());
    row_.swap(next_);
    return proven >= 1;
}

/// Opens the angles between the brooms a little at a time until the way ahead is free for a step.
bool LadderSpace::enlarge(std::span<const double> target, Configurations& visited) {
    std::vector<double> opened(row_), ahead(row_.size());
    for (std::size_t attempt = 0; attempt < options_.enlarge_tries; ++attempt) {
        for (std::size_t i = 3; i < opened.size(); ++i) opened[i] *= 1 - options_.enlarge_share;
        if (!straight_.checker().valid(row_, opened)) return false;
        const double proven = straight_.checker().valid_prefix(opened, target, options_.step);
        if (proven < 0) return false;
        for (std::size_t i = 0; i < ahead.size(); ++i)
            ahead[i] = opened[i] + proven * (target[i] - opened[i]);
        if (farthest_motion(opened, ahead) < 2 * options_.step) continue;
        visited.insert(visited.end(), opened.begin(), opened.end());
        row_ = opened;
        return true;
    }
    return false;
}

/// Moves in x alone, then in y alone, and so on, until both fail or the target's place is met.
bool LadderSpace::climb_ladder(std::span<const double> target, Configurations& visited) {
    bool climbed = false;
    for (bool moved = true; moved;) {
        moved = false;
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
            const double wanted = target[axis] - row_[axis];
            if (std::abs(wanted) < options_.step) continue;
            next_ = row_;
            next_[axis] = target[axis];
            const double proven = straight_.checker().valid_prefix(row_, next_, options_.step);
            if (proven * std::abs(wanted) < options_.step) continue;
            next_[axis] = proven >= 1 ? target[axis] : row_[axis] + proven * wanted;
            visited.insert(visited.end(), next_.begin(), next_.end());
            row_ = next_;
            moved = climbed = true;
        }
    }
    return climbed;
}

double LadderSpace::farthest_motion(std::span<const double> a, std::span<const double> b) {
    world_.chain.forward(a, pose_);
    world_.chain.forward(b, other_pose_);
    double most = 0;
    for (std::size_t j = 0; j < pose_.x.size(); ++j)
        most = std::max(
            most, elementary::hypot(pose_.x[j] - other_pose_.x[j], pose_.y[j] - other_pose_.y[j]));
    return most;
}

}  // namespace asv::core
