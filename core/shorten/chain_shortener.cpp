#include "core/shorten/chain_shortener.hpp"

#include <algorithm>
#include <utility>

#include "core/shorten/hybridise.hpp"
#include "core/shorten/shortcutter.hpp"

namespace asv::core {

namespace {

/// So many shortcuts in a row without a gain, and it is time for the other method.
constexpr int shortcut_patience = 60;
/// Of the path, as long as a shortcut may be; drawn for each.
constexpr double chain_shortcut_shares[] = {1.0, 0.5, 0.25, 0.1};
/// Times that the path is pulled at one spacing, and the share of the cost that one pull has to
/// gain to go on.
constexpr int most_pulls = 30;
constexpr double min_pull_gain = 2e-4;
/// A round of everything that gains less than this share of the cost is the last one.
constexpr double min_round_gain = 1e-4;

}  // namespace

double microseconds(const ChainWork& done, std::size_t asv_count, std::size_t obstacle_count) {
    // Fitted to the times of 18 problems with 3 to 25 ASVs and 2 to 100 obstacles; few obstacles
    // are looked at one by one, of many only those near by.
    const auto n = static_cast<double>(asv_count);
    const auto looked_at = static_cast<double>(std::min<std::size_t>(obstacle_count, 16));
    return static_cast<double>(done.state_checks) * (0.05 + 0.01 * n * (1 + looked_at)) +
           static_cast<double>(done.constrained_steps) * (2.3 + 0.4 * n) +
           static_cast<double>(done.way_point_steps) * (0.8 + 0.032 * n * n);
}

ChainShortener::ChainShortener(MotionChecker& checker, const Metric& metric,
                               SlideSteering& steering)
    : checker_(checker),
      metric_(metric),
      steering_(steering),
      band_(checker, metric),
      cost_(checker.chain()) {}

double ChainShortener::work() const {
    return microseconds({checker_.state_checks(), steering_.steps(), band_.way_point_steps()},
                        checker_.chain().asv_count(), checker_.field().boxes().size());
}

/// Both methods by turns, until neither gains.
void ChainShortener::shorten(Improvement& improvement, Rng& rng) {
    for (double before = 0; before != improvement.cost() && !improvement.finished();) {
        before = improvement.cost();
        shortcut(improvement, shortcut_patience, rng);
        if (improvement.hopeless()) return;
        for (const double spacing : {coarse_spacing, fine_spacing})
            pull_taut(improvement, spacing, most_pulls);
        if (before - improvement.cost() < min_round_gain * improvement.cost()) return;
    }
}

void ChainShortener::cross(const Configurations& earlier, Improvement& improvement, Rng& rng) {
    if (improvement.finished()) return;
    const Bridge slide = [&](auto from, auto to, Configurations& between) {
        return !improvement.finished() && steering_.slide(from, to, between) == Steered::reached;
    };
    Configurations crossed = hybridise(earlier, improvement.path(), metric_, cost_, slide);
    if (cost_.path(crossed) >= improvement.best_cost() * (1 - min_round_gain)) return;
    improvement.take(std::move(crossed));
    shorten(improvement, rng);
}

void ChainShortener::shortcut(Improvement& improvement, int patience, Rng& rng) {
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
    Shortcutter shortcutter(checker_.chain(), improvement.path());
    /// The position alone, or the heading, or one joint.
    const auto attempt_partial = [&](double share) {
        const std::size_t which = rng.below(1 + angles);
        const std::size_t first = which == 0 ? 0 : 1 + which, count = which == 0 ? 2 : 1;
        return shortcutter.attempt_partial(first, count, valid, share, rng);
    };
    for (int failures = 0; failures < patience && !improvement.finished();) {
        const double share = chain_shortcut_shares[rng.below(std::size(chain_shortcut_shares))];
        const std::size_t kind = rng.below(3);
        const bool gained = kind == 0   ? shortcutter.attempt(straight, share, rng)
                            : kind == 1 ? shortcutter.attempt(slide, share, rng)
                                        : attempt_partial(share);
        failures = gained ? 0 : failures + 1;
        if (gained) improvement.keep(shortcutter.path(), shortcutter.cost());
    }
}

void ChainShortener::pull_taut(Improvement& improvement, double spacing, int max_pulls) {
    band_.take(improvement.path(), spacing);
    const auto finished = [&] { return improvement.finished(); };
    for (int pull = 0; pull < max_pulls && !finished(); ++pull)
        if (band_.tighten(finished) < min_pull_gain * improvement.cost()) break;
    improvement.keep(band_.path());
}

}  // namespace asv::core
