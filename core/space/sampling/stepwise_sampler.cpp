#include "core/space/sampling/stepwise_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/space/sampling/passage_points.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

using geometry::Box;
using geometry::Point;

namespace {

/// Draws of one heading before the chain so far is given up.
constexpr int heading_tries = 8;

}  // namespace

StepwiseSampler::StepwiseSampler(MotionChecker& checker, double sharpest_turn)
    : checker_(checker), sharpest_turn_(sharpest_turn), positions_(checker.chain().asv_count()) {}

bool StepwiseSampler::sample(Rng& rng, From from, std::optional<Point> place, bool any_turn,
                             std::span<double> row) {
    const MotionChecker& checker = checker_;
    if (!place) place = free_point(checker.field(), checker.constraints().bounds, rng);
    if (!place || checker.field().contains(*place)) return false;
    positions_[0] = *place;
    // Built from its last ASV on, a chain that turns left turns right.
    const double sign = from == From::first_asv ? 1 : -1;
    const double sharpest = any_turn ? checker.constraints().max_turn : sharpest_turn_;
    if (!grow(rng, sign, sharpest)) return false;
    if (from == From::last_asv) std::reverse(positions_.begin(), positions_.end());
    checker.chain().configuration(positions_, row);
    // Straight joints come back from the positions with the rounding of the arc tangent.
    for (std::size_t i = 0; i < checker.chain().turn_count(); ++i)
        row[3 + i] = std::max(row[3 + i], 0.0);
    return checker_.valid(row);
}

bool StepwiseSampler::grow(Rng& rng, double sign, double sharpest) {
    const double length = checker_.chain().broom_length();
    double heading = 0;
    for (std::size_t k = 0; k + 1 < positions_.size(); ++k) {
        bool placed = false;
        for (int attempt = 0; attempt < heading_tries && !placed; ++attempt) {
            const double drawn = k == 0 ? rng.uniform(-std::numbers::pi, std::numbers::pi)
                                        : heading + sign * rng.uniform(0, sharpest);
            positions_[k + 1] = {positions_[k].x + length * elementary::cos(drawn),
                                 positions_[k].y + length * elementary::sin(drawn)};
            placed = free(positions_[k], positions_[k + 1]);
            if (placed) heading = drawn;
        }
        if (!placed) return false;
    }
    return true;
}

bool StepwiseSampler::free(const Point& a, const Point& b) {
    const Box& bounds = checker_.constraints().bounds;
    if (b.x < bounds.low.x || b.x > bounds.high.x || b.y < bounds.low.y || b.y > bounds.high.y)
        return false;
    return !checker_.field().meets(geometry::Segment{a, b});
}

}  // namespace asv::core
