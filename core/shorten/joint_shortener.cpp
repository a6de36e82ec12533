#include "core/shorten/joint_shortener.hpp"

#include <iterator>
#include <utility>

#include "core/shorten/shortcutter.hpp"

namespace asv::core {

namespace {

/// So many shortcuts in a row without a gain, and the path is as short as they make it.
constexpr int failures_to_end = 200;
/// After so many shortcuts it is seen whether a path is worth more.
constexpr int attempts_to_judge = 100;
/// Of the shortcuts, those of one joint alone.
constexpr double partial_share = 0.5;
/// Of the path, as long as a shortcut may be; drawn for each. Twice the path: often from end to
/// end.
constexpr double joint_shortcut_shares[] = {2.0, 1.0, 0.5, 0.25, 0.1};

}  // namespace

double microseconds(std::uint64_t state_checks, std::uint64_t motion_checks,
                    std::size_t dimension) {
    const auto d = static_cast<double>(dimension);
    return static_cast<double>(state_checks) * (0.2 + 0.07 * d) +
           static_cast<double>(motion_checks) * (2 + 0.7 * d);
}

double path_cost(const JointSpace& space, const Configurations& path) {
    const std::size_t d = space.dimension();
    double sum = 0;
    for (std::size_t i = d; i < path.size(); i += d)
        sum += space.cost({path.data() + i - d, d}, {path.data() + i, d});
    return sum;
}

double JointShortener::work() const {
    return microseconds(space_.state_checks(), space_.motion_checks(), space_.dimension());
}

void JointShortener::shorten(Improvement& improvement, Rng& rng) {
    const Bridge straight = [&](auto from, auto to, Configurations& between) {
        if (!space_.motion_valid(from, to)) return false;
        between.assign(to.begin(), to.end());
        return true;
    };
    const auto valid = [&](auto from, auto to) { return space_.motion_valid(from, to); };
    const auto cost = [&](auto from, auto to) { return space_.cost(from, to); };
    Shortcutter shortcutter(space_.dimension(), cost, improvement.path());
    const auto attempt_one_joint = [&](double share) {
        return shortcutter.attempt_partial(rng.below(space_.dimension()), 1, valid, share, rng);
    };
    int attempts = 0;
    for (int failures = 0; failures < failures_to_end && !improvement.finished();) {
        if (++attempts == attempts_to_judge && improvement.hopeless()) return;
        const double share = joint_shortcut_shares[rng.below(std::size(joint_shortcut_shares))];
        const bool gained = rng.chance(partial_share) ? attempt_one_joint(share)
                                                      : shortcutter.attempt(straight, share, rng);
        failures = gained ? 0 : failures + 1;
        if (gained) improvement.keep(shortcutter.path(), shortcutter.cost());
    }
}

}  // namespace asv::core
