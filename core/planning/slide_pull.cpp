#include "asv/core/planning/slide_pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asv/core/space/sampling/passage_points.hpp"
#include "asv/core/space/sampling/shape_sampler.hpp"

namespace asv::core {

namespace {

class Search {
  public:
    Search(MotionChecker& checker, const Metric& metric, const SlidePullOptions& options, Rng& rng)
        : checker_(checker),
          chain_(checker.chain()),
          options_(options),
          rng_(rng),
          steering_(checker, metric, options.steering),
          sampler_(checker),
          pose_(chain_.make_pose()),
          sample_(chain_.dimension()),
          target_(chain_.dimension()) {
        const NearestNeighbours empty(metric.scales(), heading());
        trees_.assign(2, Tree(empty));
    }

    SlidePullResult run(std::span<const double> start, std::span<const double> goal,
                        const Limits& limits) {
        SlidePullResult result;
        trees_[0].add(start, Tree::none);
        trees_[1].add(goal, Tree::none);
        bool found = connect(0, 0);
        while (!found && !limits.expired() && result.iterations < limits.max_iterations) {
            ++result.iterations;
            const int side = trees_[0].size() <= trees_[1].size() ? 0 : 1;
            const bool pulled = options_.pull && rng_.chance(options_.pull_share);
            const auto added = pulled ? pull(side) : extend(side);
            if (added != Tree::none) found = connect(side, added);
        }
        result.nodes[0] = trees_[0].size();
        result.nodes[1] = trees_[1].size();
        if (found) {
            result.solved = true;
            result.path = join();
        }
        return result;
    }

  private:
    std::optional<std::size_t> heading() const {
        return chain_.asv_count() > 1 ? std::optional<std::size_t>(2) : std::nullopt;
    }

    /// Turns the row's heading by full turns until it is nearest to that of the other row.
    void unwrap(std::span<double> row, std::span<const double> other) const {
        if (!heading()) return;
        constexpr double full = 2 * std::numbers::pi;
        row[2] -= full * std::round((row[2] - other[2]) / full);
    }

    std::uint32_t add_visited(int side, std::uint32_t parent) {
        const std::size_t d = chain_.dimension();
        for (std::size_t i = 0; i < visited_.size(); i += d)
            parent = trees_[side].add({visited_.data() + i, d}, parent);
        return parent;
    }

    Steered steer(std::uint32_t node, int side) {
        visited_.clear();
        const auto from = trees_[side].row(node);
        unwrap(target_, from);
        return steering_.slide(from, target_, visited_);
    }

    std::uint32_t extend(int side) {
        if (!sampler_.sample(rng_, sample_)) return Tree::none;
        target_ = sample_;
        const auto nearest = trees_[side].nearest(target_);
        if (steer(nearest, side) == Steered::trapped) return Tree::none;
        return add_visited(side, nearest);
    }

    std::uint32_t pull(int side) {
        const auto& field = checker_.field();
        const auto& bounds = checker_.constraints().bounds;
        std::optional<Point> point;
        if (rng_.chance(options_.passage_share)) point = passage_point(field, bounds, rng_);
        if (!point) point = free_point(field, bounds, rng_);
        if (!point) return Tree::none;
        const std::size_t asv = rng_.chance(0.5) ? 0 : chain_.asv_count() - 1;
        std::uint32_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < options_.pull_candidates; ++i) {
            const auto node = static_cast<std::uint32_t>(rng_.below(trees_[side].size()));
            chain_.forward(trees_[side].row(node), pose_);
            const double distance = std::hypot(pose_.x[asv] - point->x, pose_.y[asv] - point->y);
            if (distance < least) {
                least = distance;
                best = node;
            }
        }
        visited_.clear();
        if (steering_.pull(trees_[side].row(best), asv, *point, visited_) == Steered::trapped)
            return Tree::none;
        return add_visited(side, best);
    }

    bool connect(int side, std::uint32_t node) {
        const int other = 1 - side;
        const auto row = trees_[side].row(node);
        target_.assign(row.begin(), row.end());
        const auto nearest = trees_[other].nearest(target_);
        const Steered outcome = steer(nearest, other);
        const auto last = add_visited(other, nearest);
        if (outcome != Steered::reached) return false;
        meeting_[side] = node;
        meeting_[other] = last;
        return true;
    }

    Rows join() {
        auto forward = trees_[0].to_root(meeting_[0]);
        std::reverse(forward.begin(), forward.end());
        Rows path;
        for (const auto node : forward) {
            const auto row = trees_[0].row(node);
            path.insert(path.end(), row.begin(), row.end());
        }
        double turn = 0;
        const std::size_t d = chain_.dimension();
        bool first = true;
        for (const auto node : trees_[1].to_root(meeting_[1])) {
            const auto row = trees_[1].row(node);
            if (first && heading()) turn = path[path.size() - d + 2] - row[2];
            if (!first) {
                path.insert(path.end(), row.begin(), row.end());
                if (heading()) path[path.size() - d + 2] += turn;
            }
            first = false;
        }
        return path;
    }

    MotionChecker& checker_;
    const Chain& chain_;
    const SlidePullOptions& options_;
    Rng& rng_;
    SlideSteering steering_;
    ShapeSampler sampler_;
    Pose pose_;
    std::vector<double> sample_, target_;
    std::vector<Tree> trees_;
    Rows visited_;
    std::uint32_t meeting_[2] = {0, 0};
};

}  // namespace

SlidePullResult slide_pull(MotionChecker& checker, const Metric& metric,
                           std::span<const double> start, std::span<const double> goal,
                           const SlidePullOptions& options, const Limits& limits, Rng& rng) {
    Search search(checker, metric, options, rng);
    return search.run(start, goal, limits);
}

}  // namespace asv::core
