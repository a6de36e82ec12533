#include "core/shorten/improve_joints.hpp"

#include <utility>

#include "core/shorten/shortcutter.hpp"

namespace asv::core {

namespace {

/// So many shortcuts in a row without a gain, and the path is as short as they make it.
constexpr int patience = 200;
/// Searches in a row that fail before no more are tried.
constexpr int max_failures = 5;
/// Nearer to the lower bound there is nothing to gain, in shares of it.
constexpr double negligible = 1e-5;

class JointImprovement {
  public:
    JointImprovement(JointSpace& space, double lower_bound, double work, const Limits& limits,
                     Rng& rng, const std::function<void(double)>& on_better)
        : space_(space),
          good_enough_(lower_bound * (1 + negligible)),
          limits_(limits),
          rng_(rng),
          on_better_(on_better),
          end_(spent() + work) {}

    Configurations run(Configurations path, const std::function<AnotherPath(Rng&)>& another) {
        best_ = path_cost(space_, path);
        best_path_ = path;
        shortcut(std::move(path));
        int failures = 0;
        while (another && failures < max_failures && !finished()) {
            AnotherPath other = another(rng_);
            end_ -= other.work;
            failures = other.path.empty() ? failures + 1 : 0;
            if (!other.path.empty()) shortcut(std::move(other.path));
        }
        return std::move(best_path_);
    }

  private:
    double spent() const {
        return joint_work_of(space_.state_checks(), space_.motion_checks(), space_.dimension());
    }

    bool finished() const { return best_ <= good_enough_ || spent() >= end_ || limits_.expired(); }

    void shortcut(Configurations path) {
        const Bridge straight = [&](auto from, auto to, Configurations& between) {
            if (!space_.motion_valid(from, to)) return false;
            between.assign(to.begin(), to.end());
            return true;
        };
        const auto cost = [&](auto from, auto to) { return space_.cost(from, to); };
        Shortcutter shortcutter(space_.dimension(), cost, std::move(path));
        keep(shortcutter);
        for (int failures = 0; failures < patience && !finished();) {
            const double shares[] = {2.0, 1.0, 0.5, 0.25, 0.1};
            const bool gained = shortcutter.attempt(straight, shares[rng_.below(5)], rng_);
            failures = gained ? 0 : failures + 1;
            if (gained) keep(shortcutter);
        }
    }

    void keep(const Shortcutter& shortcutter) {
        if (shortcutter.cost() >= best_) return;
        best_ = shortcutter.cost();
        best_path_ = shortcutter.path();
        if (on_better_) on_better_(best_);
    }

    JointSpace& space_;
    double good_enough_;
    const Limits& limits_;
    Rng& rng_;
    const std::function<void(double)>& on_better_;
    double end_;
    Configurations best_path_;
    double best_ = 0;
};

}  // namespace

double path_cost(const JointSpace& space, const Configurations& path) {
    const std::size_t d = space.dimension();
    double sum = 0;
    for (std::size_t i = d; i < path.size(); i += d)
        sum += space.cost({path.data() + i - d, d}, {path.data() + i, d});
    return sum;
}

double joint_work_of(std::uint64_t state_checks, std::uint64_t motion_checks,
                     std::size_t dimension) {
    const auto d = static_cast<double>(dimension);
    return static_cast<double>(state_checks) * (0.2 + 0.07 * d) +
           static_cast<double>(motion_checks) * (2 + 0.7 * d);
}

Configurations improve_joints(Configurations path, JointSpace& space,
                              const std::function<AnotherPath(Rng&)>& another, double lower_bound,
                              double work, const Limits& limits, Rng& rng,
                              const std::function<void(double)>& on_better) {
    return JointImprovement(space, lower_bound, work, limits, rng, on_better)
        .run(std::move(path), another);
}

}  // namespace asv::core
