#include "core/shorten/improve.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace asv::core {

namespace {

/// A path that costs so many times the best one after its first shortcuts is given up.
constexpr double hopeless_ratio = 1.25;
/// Searches that fail, and from then on each may take so many times as long.
constexpr int failures_to_grow = 5;
constexpr double patience_growth = 2;
/// Microseconds that a search takes at least, whatever it counts: one that goes straight to the
/// goal counts next to nothing, and could be tried for ever.
constexpr double min_search_work = 50;

}  // namespace

Improvement::Improvement(PathShortener& shortener, const ImproveOptions& options)
    : shortener_(shortener),
      options_(options),
      end_of_work_(shortener.work() + options.work),
      best_cost_(std::numeric_limits<double>::infinity()) {}

void Improvement::take(Configurations path) {
    path_ = std::move(path);
    cost_ = shortener_.cost(path_);
    if (cost_ < best_cost_) note_best();
}

void Improvement::keep(const Configurations& path) {
    keep(path, shortener_.cost(path));
}

void Improvement::keep(const Configurations& path, double cost) {
    if (cost >= cost_) return;
    cost_ = cost;
    path_ = path;
    if (cost_ < best_cost_) note_best();
}

void Improvement::note_best() {
    const bool first = best_path_.empty();
    best_cost_ = cost_;
    best_path_ = path_;
    if (options_.on_better && !first) options_.on_better(best_cost_);
}

double Improvement::work_left() const {
    return end_of_work_ - shortener_.work();
}

bool Improvement::hopeless() const {
    return cost_ > hopeless_ratio * best_cost_;
}

bool Improvement::finished() const {
    return optimal() || work_left() <= 0 || options_.limits.expired();
}

Configurations improve(Configurations path, PathShortener& shortener, const ImproveOptions& options,
                       Rng& rng) {
    Improvement improvement(shortener, options);
    improvement.take(std::move(path));
    shortener.shorten(improvement, rng);
    double patience = 1;
    for (int failures = 0; options.another && !improvement.finished();) {
        AnotherPath other = options.another(rng, patience);
        improvement.charge(std::max(other.work, min_search_work));
        failures = other.path.empty() ? failures + 1 : 0;
        if (failures == failures_to_grow) {
            failures = 0;
            patience *= patience_growth;
        }
        if (other.path.empty()) continue;
        const Configurations earlier = improvement.best_path();
        improvement.take(std::move(other.path));
        shortener.shorten(improvement, rng);
        shortener.cross(earlier, improvement, rng);
    }
    return improvement.best_path();
}

}  // namespace asv::core
