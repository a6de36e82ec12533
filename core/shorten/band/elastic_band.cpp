#include "core/shorten/band/elastic_band.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Steps down to the least barrier, and how it falls. It begins where contacts are felt over the
/// thickness of a wall and ends where they are felt over the gap that is kept.
constexpr int pulls = 6;
constexpr double first_barrier = 1e-3;
constexpr double barrier_fall = 0.2;
constexpr double last_barrier = 1e-6;
/// Steps that heal what the pulls have left not quite valid, each damped so many times as much.
constexpr int repairs = 10;
constexpr double repair_damping = 2;
/// Reach of the contacts while pulling and while repairing, and the most that an ASV moves in one
/// step, as shares of the spacing.
constexpr double pull_reach = 1;
constexpr double repair_reach = 0.2;
constexpr double farthest = 0.3;
/// ASVs that hardly move pull with a bounded force; as a share of the spacing.
constexpr double band_softening = 0.02;
/// Damping to begin with, in units of the stiffness of a tie over the spacing; what it falls to
/// with every success and rises to with every failure; its least.
constexpr double first_damping = 1;
constexpr double damping_fall = 0.3;
constexpr double damping_rise = 10;
constexpr double min_damping = 1e-3;
/// Times that a way point goes half the way back before it goes all of it.
constexpr int max_halvings = 2;
/// A way point whose absence costs less than this share of its motions is not needed.
constexpr double needless = 1e-6;

}  // namespace

ElasticBand::ElasticBand(MotionChecker& checker, const Metric& metric)
    : checker_(checker),
      metric_(metric),
      chain_(checker.chain()),
      dimension_(chain_.dimension()),
      path_(chain_),
      proposed_(chain_),
      ties_(chain_),
      contacts_(checker),
      cost_(chain_),
      pose_(chain_.make_pose()) {}

void ElasticBand::take(const Configurations& path, double spacing) {
    path_.rows = resampled(path, metric_, spacing);
    spacing_ = spacing;
    damping_ = first_damping / spacing;
    cost_now_ = cost_.path(path_.rows);
}

double ElasticBand::tighten(const std::function<bool()>& stop) {
    if (path_.count() < 3) return 0;
    const Configurations before = path_.rows;
    proposed_.rows = path_.rows;
    if (!pull(stop) || !repair(stop)) {
        path_.rows = before;
        return 0;
    }
    keep_valid();
    const double cost = cost_.path(proposed_.rows);
    const double gained = cost_now_ - cost;
    if (gained <= 0) {
        path_.rows = before;
        damping_ *= damping_rise;
        return 0;
    }
    damping_ = std::max(damping_fall * damping_, min_damping);
    path_.rows.swap(proposed_.rows);
    thin(spacing_, needless);
    cost_now_ = cost_.path(path_.rows);
    return gained;
}

/// Steps toward the taut path while the contacts give way less and less; false when stopped.
bool ElasticBand::pull(const std::function<bool()>& stop) {
    proposed_.stand();
    contacts_.find(proposed_, pull_reach * spacing_, first_barrier);
    double barrier = first_barrier;
    for (int i = 0; i < pulls && step(damping_, barrier); ++i) {
        if (stop()) return false;
        barrier = std::max(barrier_fall * barrier, last_barrier);
        proposed_.stand();
    }
    return true;
}

/// Small steps that push what is not valid out of what it meets, with more way points there; false
/// when stopped.
bool ElasticBand::repair(const std::function<bool()>& stop) {
    double damping = damping_;
    for (int i = 0; i < repairs; ++i) {
        if (stop()) return false;
        damping *= repair_damping;
        proposed_.stand();
        if (i % 2 == 0) contacts_.find(proposed_, repair_reach * spacing_, first_barrier);
        if (!step(damping, last_barrier)) break;
        if (i % 2 == 1 && !refine()) break;
    }
    return true;
}

/// One step of all way points; false when the system could not be solved.
bool ElasticBand::step(double damping, double barrier) {
    step_.resize((proposed_.count() - 2) * dimension_);
    ties_.tie(proposed_.poses, band_softening * spacing_, damping, system_, step_);
    contacts_.press(proposed_, barrier, system_, step_);
    if (!system_.solve(step_)) return false;
    contacts_.follow(step_);
    for (std::size_t i = 1; i + 1 < proposed_.count(); ++i)
        advance(i, {step_.data() + (i - 1) * dimension_, dimension_});
    way_point_steps_ += proposed_.count();
    return true;
}

/// Moves a way point by a step in heading coordinates, or by as much of it as moves no ASV farther
/// than the model can be trusted.
void ElasticBand::advance(std::size_t i, std::span<const double> step) {
    const auto row = proposed_.row(i);
    const Pose& before = proposed_.poses[i];
    const auto& least = checker_.constraints().min_turn;
    const double most = checker_.constraints().max_turn;
    from_.assign(row.begin(), row.end());
    double share = 1;
    for (int attempt = 0; attempt < 2; ++attempt) {
        for (std::size_t k = 0; k < std::min<std::size_t>(dimension_, 3); ++k)
            row[k] = from_[k] + share * step[k];
        for (std::size_t t = 0; t < chain_.turn_count(); ++t) {
            const double turn = share * (step[3 + t] - step[2 + t]);
            row[2] += chain_.heading_share()[t] * turn;
            row[3 + t] = std::clamp(from_[3 + t] + turn, least[t], most);
        }
        chain_.forward(row, pose_);
        double moved = 0;
        for (std::size_t j = 0; j < pose_.x.size(); ++j)
            moved = std::max(moved,
                             elementary::hypot(pose_.x[j] - before.x[j], pose_.y[j] - before.y[j]));
        if (moved <= farthest * spacing_) return;
        share = 0.99 * farthest * spacing_ / moved;
    }
}

/// Puts a way point into the middle of each motion that is not proven; false when there is none.
bool ElasticBand::refine() {
    Configurations rows, proposed;
    const auto copy = [](std::span<const double> row, Configurations& out) {
        out.insert(out.end(), row.begin(), row.end());
    };
    const auto copy_middle = [](std::span<const double> a, std::span<const double> b,
                                Configurations& out) {
        for (std::size_t k = 0; k < a.size(); ++k) out.push_back(0.5 * (a[k] + b[k]));
    };
    for (std::size_t i = 0; i < path_.count(); ++i) {
        copy(path_.row(i), rows);
        copy(proposed_.row(i), proposed);
        if (i + 1 == path_.count() || checker_.valid(proposed_.row(i), proposed_.row(i + 1)))
            continue;
        copy_middle(path_.row(i), path_.row(i + 1), rows);
        copy_middle(proposed_.row(i), proposed_.row(i + 1), proposed);
    }
    if (rows.size() == path_.rows.size()) return false;
    path_.rows.swap(rows);
    proposed_.rows.swap(proposed);
    return true;
}

/// Lets way points go back, half the way and then all of it, until every motion is proven: at the
/// latest where both of its ends are back on the path.
void ElasticBand::keep_valid() {
    const std::size_t motions = path_.count() - 1;
    std::vector<int> halvings(path_.count(), 0);
    std::vector<char> doubtful(motions, 1), blocked(path_.count());
    for (bool again = true; again;) {
        again = false;
        std::fill(blocked.begin(), blocked.end(), 0);
        for (std::size_t i = 0; i < motions; ++i)
            if (doubtful[i] && !checker_.valid(proposed_.row(i), proposed_.row(i + 1)))
                blocked[i] = blocked[i + 1] = 1;
        std::fill(doubtful.begin(), doubtful.end(), 0);
        for (std::size_t i = 1; i < motions; ++i) {
            if (!blocked[i] || halvings[i] > max_halvings) continue;
            const bool all_the_way = ++halvings[i] > max_halvings;
            const auto row = proposed_.row(i), home = path_.row(i);
            for (std::size_t k = 0; k < dimension_; ++k)
                row[k] = all_the_way ? home[k] : row[k] + 0.5 * (home[k] - row[k]);
            doubtful[i - 1] = doubtful[i] = 1;
            again = true;
        }
    }
}

Configurations ElasticBand::path() {
    thin(std::numeric_limits<double>::infinity(), 1e-9);
    cost_now_ = cost_.path(path_.rows);
    return path_.rows;
}

/// Takes out way points where the motion past them is short, proven, and costs no more than what
/// it replaces but for a share of that.
void ElasticBand::thin(double longest, double tolerance) {
    const std::size_t count = path_.count();
    std::size_t kept = 1;
    std::optional<double> to_here;  // what the motion from the last kept way point costs
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const auto last = path_.row(kept - 1), here = path_.row(i), next = path_.row(i + 1);
        std::optional<double> from_here;
        if (metric_.distance(last, next) < longest) {
            if (!to_here) to_here = cost_(last, here);
            from_here = cost_(here, next);
            const double past = cost_(last, next);
            if (past <= (*to_here + *from_here) * (1 + tolerance) && checker_.valid(last, next)) {
                to_here = past;
                continue;
            }
        }
        to_here = from_here;
        std::copy(here.begin(), here.end(), path_.row(kept).begin());
        ++kept;
    }
    const auto goal = path_.row(count - 1);
    std::copy(goal.begin(), goal.end(), path_.row(kept).begin());
    path_.rows.resize((kept + 1) * dimension_);
}

}  // namespace asv::core
