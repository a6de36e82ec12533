#include "core/space/sampling/shape_sampler.hpp"

#include <algorithm>
#include <numbers>

namespace asv::core {

namespace {

constexpr int shape_tries = 200;
constexpr int place_tries = 40;
/// Dirichlet concentrations: below 1 a few joints take most of the turn, above 1 it is even.
constexpr double concentrations[] = {0.3, 1.0, 3.0, 20.0};

}  // namespace

ShapeSampler::ShapeSampler(MotionChecker& checker)
    : checker_(checker), pose_(checker.chain().make_pose()) {}

bool ShapeSampler::valid_shape(std::span<const double> row) {
    const ChainConstraints& limits = checker_.constraints();
    for (std::size_t i = 3; i < row.size(); ++i)
        if (row[i] > limits.max_turn) return false;
    checker_.chain().forward(row, pose_);
    return area(pose_) >= limits.min_area &&
           first_closing_turn(pose_) >= limits.min_first_closing_turn &&
           last_closing_turn(pose_) >= limits.min_last_closing_turn &&
           closing_side(pose_) >= limits.min_closing_side;
}

bool ShapeSampler::sample_shape(Rng& rng, std::span<double> row) {
    const Chain& chain = checker_.chain();
    const std::size_t turns = chain.turn_count();
    row[0] = row[1] = 0;
    if (chain.asv_count() > 1) row[2] = 0;
    if (turns == 0) return true;
    for (int attempt = 0; attempt < shape_tries; ++attempt) {
        const double concentration = concentrations[rng.below(std::size(concentrations))];
        const double total = rng.uniform(0, 2 * std::numbers::pi);
        double sum = 0;
        for (std::size_t i = 0; i < turns; ++i) sum += row[3 + i] = rng.gamma(concentration);
        if (!(sum > 0)) continue;
        for (std::size_t i = 0; i < turns; ++i) row[3 + i] *= total / sum;
        if (valid_shape(row)) return true;
    }
    return false;
}

bool ShapeSampler::sample(Rng& rng, std::span<double> row) {
    if (!sample_shape(rng, row)) return false;
    const geometry::Box& bounds = checker_.constraints().bounds;
    for (int attempt = 0; attempt < place_tries; ++attempt) {
        row[0] = rng.uniform(bounds.low.x, bounds.high.x);
        row[1] = rng.uniform(bounds.low.y, bounds.high.y);
        if (row.size() > 2) row[2] = rng.uniform(-std::numbers::pi, std::numbers::pi);
        if (checker_.valid(row)) return true;
    }
    return false;
}

bool ShapeSampler::sample_near(Rng& rng, const geometry::Point& point, double deviation,
                               std::span<double> row) {
    if (!sample_shape(rng, row)) return false;
    for (int attempt = 0; attempt < place_tries; ++attempt) {
        row[0] = row[1] = 0;
        if (row.size() > 2) row[2] = rng.uniform(-std::numbers::pi, std::numbers::pi);
        checker_.chain().forward(row, pose_);
        const std::size_t middle = pose_.x.size() / 2;
        row[0] = point.x - pose_.x[middle] + deviation * rng.normal();
        row[1] = point.y - pose_.y[middle] + deviation * rng.normal();
        if (checker_.valid(row)) return true;
    }
    return false;
}

}  // namespace asv::core
