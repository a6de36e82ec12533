#include "core/space/steering/slide.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Steps shorter than this share of the longest are not worth their cost.
constexpr double shortest_share = 1.0 / 16;
/// A long straight stretch is kept in pieces of about this length, so that the tree can branch.
constexpr double longest_edge = 0.1;
/// How stiff a pull is against the wish to stay, per unit of squared scaled motion.
constexpr double stiffness = 100;

}  // namespace

SlideSteering::SlideSteering(MotionChecker& checker, const Metric& metric,
                             const SlideOptions& options)
    : checker_(checker),
      metric_(metric),
      options_(options),
      constrained_(checker.chain(), checker.constraints(), checker.field(), metric) {
    for (auto* array : {&row_, &next_, &wish_}) array->resize(metric.dimension());
    // In a crowd, a longer step would only meet more boxes than it can heed.
    options_.step = std::min(options_.step, 2 * checker.field().spacing());
}

Steered SlideSteering::slide(std::span<const double> from, std::span<const double> target,
                             Configurations& visited) {
    std::copy(from.begin(), from.end(), row_.begin());
    Pace pace{options_.step, options_.margin};
    bool free_ahead = true;
    Steered outcome = Steered::trapped;
    for (std::size_t i = 0; i < options_.max_steps; ++i) {
        double distance = metric_.distance(row_, target);
        // A constrained step may end on the target itself, from where there is no direction.
        if (distance == 0 && outcome == Steered::advanced) return Steered::reached;
        if (free_ahead) {
            const std::size_t before = visited.size();
            if (go_straight(target, distance, visited)) return Steered::reached;
            if (visited.size() > before) outcome = Steered::advanced;
            if (!options_.slide) return outcome;
            distance = metric_.distance(row_, target);
        }
        const double length = std::min(pace.step, distance);
        for (std::size_t k = 0; k < wish_.size(); ++k)
            wish_[k] = (target[k] - row_[k]) * metric_.scale(k) * (length / distance);
        constrained_.linearise(row_, length, pace.margin, pace.margin / options_.margin);
        const auto next = constrained_.solve(wish_);
        std::copy(next.begin(), next.end(), next_.begin());
        free_ahead = !constrained_.pushed();
        const double gained = distance - metric_.distance(next_, target);
        const StepTaken taken = take_step(gained, length, pace, visited);
        if (taken == StepTaken::stuck) return outcome;
        if (taken == StepTaken::yes) outcome = Steered::advanced;
    }
    return outcome;
}

Steered SlideSteering::pull(std::span<const double> from, std::size_t asv,
                            const geometry::Point& target, Configurations& visited) {
    std::copy(from.begin(), from.end(), row_.begin());
    Pace pace{options_.step, options_.margin};
    Steered outcome = Steered::trapped;
    std::fill(wish_.begin(), wish_.end(), 0.0);
    const Chain& chain = checker_.chain();
    Pose pose = chain.make_pose();
    for (std::size_t i = 0; i < options_.max_steps; ++i) {
        chain.forward(row_, pose);
        const double dx = target.x - pose.x[asv], dy = target.y - pose.y[asv];
        const double distance = elementary::hypot(dx, dy);
        if (distance < options_.hair) return Steered::reached;
        const double length = std::min(pace.step, distance);
        constrained_.linearise(row_, length, pace.margin, pace.margin / options_.margin);
        constrained_.pull(asv, dx * length / distance, dy * length / distance, stiffness);
        const auto next = constrained_.solve(wish_);
        std::copy(next.begin(), next.end(), next_.begin());
        chain.forward(next_, pose);
        const double left = elementary::hypot(target.x - pose.x[asv], target.y - pose.y[asv]);
        const StepTaken taken = take_step(distance - left, length, pace, visited);
        if (taken == StepTaken::stuck) return outcome;
        if (taken == StepTaken::yes) outcome = Steered::advanced;
    }
    return outcome;
}

/// Takes the constrained step to next_ if it gains enough and is proven; where it is not, the pace
/// is another one from now on.
SlideSteering::StepTaken SlideSteering::take_step(double gained, double length, Pace& pace,
                                                  Configurations& visited) {
    const auto retry = [](bool possible) { return possible ? StepTaken::no : StepTaken::stuck; };
    if (gained < options_.progress * length) return retry(tighten(pace));
    ++steps_;
    if (!checker_.valid(row_, next_)) {
        pace.step = 0.5 * length;
        return retry(pace.step >= shortest_share * options_.step || tighten(pace));
    }
    keep(visited);
    pace.step = std::min(options_.step, 2 * pace.step);
    return StepTaken::yes;
}

/// Gives up half-measures: a quarter of the margin, full steps again; false at a hair.
bool SlideSteering::tighten(Pace& pace) const {
    if (pace.margin <= options_.hair) return false;
    pace.margin = std::max(options_.hair, 0.05 * pace.margin);
    pace.step = options_.step;
    return true;
}

/// Follows the straight line as far as it is proven; true when that is all of it.
bool SlideSteering::go_straight(std::span<const double> target, double distance,
                                Configurations& visited) {
    const double proven = checker_.valid_prefix(row_, target, options_.margin);
    const double free = proven >= 1 ? 1 : proven - options_.margin / distance;
    if (free * distance < options_.step && proven < 1) return false;
    const auto pieces = static_cast<std::size_t>(std::ceil(free * distance / longest_edge));
    const std::vector<double> from(row_);
    for (std::size_t piece = 1; piece <= std::max<std::size_t>(pieces, 1); ++piece) {
        const double t = free * static_cast<double>(piece) /
                         static_cast<double>(std::max<std::size_t>(pieces, 1));
        for (std::size_t k = 0; k < next_.size(); ++k)
            next_[k] = t >= 1 ? target[k] : from[k] + t * (target[k] - from[k]);
        keep(visited);
    }
    return proven >= 1;
}

void SlideSteering::keep(Configurations& visited) {
    visited.insert(visited.end(), next_.begin(), next_.end());
    row_.swap(next_);
}

}  // namespace asv::core
