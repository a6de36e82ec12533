#include "asv/core/path/improve.hpp"

#include "asv/core/path/shorten.hpp"

namespace asv::core {

namespace {

/// So many attempts in a row without a gain, and the path is as short as shortcuts make it.
constexpr int patience = 400;

/// Microseconds, roughly, of what was done so far: measured on a 2.8 GHz core.
double work_done(const MotionChecker& checker, const SlideSteering& steering) {
    const auto n = static_cast<double>(checker.chain().asv_count());
    return static_cast<double>(checker.state_checks()) * (0.1 + 0.05 * n) +
           static_cast<double>(steering.steps()) * (0.5 + 0.25 * n);
}

}  // namespace

Rows improve(Rows path, MotionChecker& checker, SlideSteering& steering, double work,
             const Limits& limits, Rng& rng, const std::function<void(double)>& on_better) {
    Shortcutter shortcutter(checker.chain(), std::move(path));
    const Bridge straight = [&](auto from, auto to, Rows& between) {
        if (!checker.valid(from, to)) return false;
        between.assign(to.begin(), to.end());
        return true;
    };
    const Bridge slide = [&](auto from, auto to, Rows& between) {
        return steering.slide(from, to, between) == Steered::reached;
    };
    const double end = work_done(checker, steering) + work;
    int failures = 0;
    while (failures < patience && work_done(checker, steering) < end && !limits.expired()) {
        const double shares[] = {1.0, 0.5, 0.25, 0.1};
        const double share = shares[rng.below(4)];
        const bool gained = shortcutter.attempt(rng.chance(0.5) ? straight : slide, share, rng);
        failures = gained ? 0 : failures + 1;
        if (gained && on_better) on_better(shortcutter.cost());
    }
    return shortcutter.path();
}

}  // namespace asv::core
