#include "core/shorten/improve.hpp"

#include <algorithm>

#include "core/shorten/band/elastic_band.hpp"
#include "core/shorten/hybridise.hpp"
#include "core/shorten/shortcutter.hpp"

namespace asv::core {

namespace {

/// So many shortcuts in a row without a gain, and it is time for the other method.
constexpr int patience = 60;
/// Spacings of the way points of a path that is pulled taut, from coarse to fine.
constexpr double spacings[] = {0.05, 0.025};
/// Times that the path is pulled at one spacing, and the share of the cost that one pull has to
/// gain to go on.
constexpr int max_pulls = 30;
constexpr double min_gain = 2e-4;
/// A round of everything that gains less than this share of the cost is the last one.
constexpr double min_round_gain = 1e-4;
/// A path that shortcuts leave so many times as long as the best one is not worth pulling taut.
constexpr double hopeless = 1.25;
/// Microseconds that a search takes at least, whatever it counts: one that goes straight to the
/// goal counts next to nothing, and could be tried for ever.
constexpr double min_search = 50;
/// Searches in a row that fail before no more are tried.
constexpr int max_failures = 5;

/// One call of improve().
class Improvement {
  public:
    Improvement(MotionChecker& checker, const Metric& metric, SlideSteering& steering, double work,
                const Limits& limits, Rng& rng, const std::function<void(double)>& on_better)
        : checker_(checker),
          metric_(metric),
          steering_(steering),
          band_(checker, metric),
          limits_(limits),
          rng_(rng),
          on_better_(on_better),
          cost_(checker.chain()),
          end_(spent() + work) {}

    Configurations run(Configurations path, const std::function<AnotherPath(Rng&)>& another) {
        shorten(std::move(path));
        int failures = 0;
        while (another && best_ > 0 && failures < max_failures && !exhausted()) {
            AnotherPath other = another(rng_);
            end_ -= std::max(other.work, min_search);
            failures = other.path.empty() ? failures + 1 : 0;
            if (other.path.empty()) continue;
            const Configurations best = best_path_;
            shorten(std::move(other.path));
            cross(best);
        }
        return std::move(best_path_);
    }

  private:
    double spent() const {
        return work_of({checker_.state_checks(), steering_.steps(), band_.way_point_steps()},
                       checker_.chain().asv_count(), checker_.field().boxes().size());
    }

    bool exhausted() const { return spent() >= end_ || limits_.expired(); }

    /// Both methods by turns, until neither gains.
    void shorten(Configurations path) {
        path_ = std::move(path);
        current_ = cost_.path(path_);
        if (best_path_.empty()) {
            best_path_ = path_;
            best_ = current_;
        }
        for (double before = 0; before != current_ && !exhausted();) {
            before = current_;
            shortcut();
            if (current_ > hopeless * best_) return;
            for (const double spacing : spacings) pull_taut(spacing);
            if (before - current_ < min_round_gain * current_) return;
        }
    }

    /// What the present path and the best one before it give together.
    void cross(const Configurations& best) {
        if (exhausted()) return;
        const Bridge slide = [&](auto from, auto to, Configurations& between) {
            return !exhausted() && steering_.slide(from, to, between) == Steered::reached;
        };
        Configurations crossed = hybridise(best, path_, metric_, cost_, slide);
        if (cost_.path(crossed) < best_ * (1 - min_round_gain)) shorten(std::move(crossed));
    }

    void shortcut() {
        const auto valid = [&](auto from, auto to) { return checker_.valid(from, to); };
        const Bridge straight = [&](auto from, auto to, Configurations& between) {
            if (!valid(from, to)) return false;
            between.assign(to.begin(), to.end());
            return true;
        };
        const Bridge slide = [&](auto from, auto to, Configurations& between) {
            return steering_.slide(from, to, between) == Steered::reached;
        };
        const std::size_t angles = checker_.chain().broom_count();
        Shortcutter shortcutter(checker_.chain(), path_);
        for (int failures = 0; failures < patience && !exhausted();) {
            const double shares[] = {1.0, 0.5, 0.25, 0.1};
            const double share = shares[rng_.below(4)];
            bool gained = false;
            switch (rng_.below(3)) {
                case 0:
                    gained = shortcutter.attempt(straight, share, rng_);
                    break;
                case 1:
                    gained = shortcutter.attempt(slide, share, rng_);
                    break;
                default: {
                    // The position alone, or the heading, or one joint.
                    const std::size_t which = rng_.below(1 + angles);
                    gained = which == 0
                                 ? shortcutter.attempt_partial(0, 2, valid, share, rng_)
                                 : shortcutter.attempt_partial(1 + which, 1, valid, share, rng_);
                }
            }
            failures = gained ? 0 : failures + 1;
            if (gained) keep(shortcutter.path());
        }
    }

    void pull_taut(double spacing) {
        band_.take(path_, spacing);
        for (int pull = 0; pull < max_pulls && !exhausted(); ++pull)
            if (band_.tighten([this] { return exhausted(); }) < min_gain * current_) break;
        keep(band_.path());
    }

    void keep(const Configurations& path) {
        const double cost = cost_.path(path);
        if (cost >= current_) return;
        current_ = cost;
        path_ = path;
        if (current_ >= best_) return;
        best_ = current_;
        best_path_ = path_;
        if (on_better_) on_better_(best_);
    }

    MotionChecker& checker_;
    const Metric& metric_;
    SlideSteering& steering_;
    ElasticBand band_;
    const Limits& limits_;
    Rng& rng_;
    const std::function<void(double)>& on_better_;
    MotionCost cost_;
    Configurations path_, best_path_;
    double current_ = 0, best_ = 0;  ///< costs of path_ and best_path_
    double end_;
};

}  // namespace

double work_of(const WorkDone& done, std::size_t asv_count, std::size_t obstacle_count) {
    // Fitted to the times of 18 problems with 3 to 25 ASVs and 2 to 100 obstacles; few obstacles
    // are looked at one by one, of many only those near by.
    const auto n = static_cast<double>(asv_count);
    const auto looked_at = static_cast<double>(std::min<std::size_t>(obstacle_count, 16));
    return static_cast<double>(done.state_checks) * (0.05 + 0.01 * n * (1 + looked_at)) +
           static_cast<double>(done.constrained_steps) * (2.3 + 0.4 * n) +
           static_cast<double>(done.way_point_steps) * (0.8 + 0.032 * n * n);
}

Configurations improve(Configurations path, MotionChecker& checker, const Metric& metric,
                       SlideSteering& steering, const std::function<AnotherPath(Rng&)>& another,
                       double work, const Limits& limits, Rng& rng,
                       const std::function<void(double)>& on_better) {
    return Improvement(checker, metric, steering, work, limits, rng, on_better)
        .run(std::move(path), another);
}

}  // namespace asv::core
