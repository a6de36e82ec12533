#pragma once

#include <functional>

#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"

namespace asv::core {

class PathShortener;

/// Is told the cost of each better path.
using CostObserver = std::function<void(double cost)>;

/// Another path between the same ends, from a new search, and the work that it took, counted in
/// microseconds; the path is empty where the search failed.
struct AnotherPath {
    Configurations path;
    double work = 0;
};

/// Looks for another path. `patience`: how many times as long as at first it may look.
using PathFinder = std::function<AnotherPath(Rng& rng, double patience)>;

struct ImproveOptions {
    /// Microseconds of a 2.8 GHz core, roughly, that the improvement may take. They are counted by
    /// what is done, not timed, so that the same seed gives the same path on every machine.
    double work = 1e6;
    /// A path that costs no more is as good as it gets; 0 where nothing is known.
    double good_enough = 0;
    /// Finds further paths, which may pass the obstacles on other sides; none: only the given one
    /// is shortened.
    PathFinder another = {};
    Limits limits = {};           ///< end the improvement early
    CostObserver on_better = {};  ///< may be empty
};

/// The path that is being improved, the best one so far, and what is left of the work.
class Improvement {
  public:
    /// Both outlive it.
    Improvement(PathShortener& shortener, const ImproveOptions& options);

    const Configurations& path() const { return path_; }
    double cost() const { return cost_; }
    const Configurations& best_path() const { return best_path_; }
    double best_cost() const { return best_cost_; }

    /// Goes on with another path.
    void take(Configurations path);
    /// Goes on with this form of the path where it costs less.
    void keep(const Configurations& path);
    /// The same where the caller knows what the path costs.
    void keep(const Configurations& path, double cost);
    /// So much of the work was done elsewhere, microseconds.
    void charge(double work) { end_of_work_ -= work; }
    /// Microseconds of work that are left.
    double work_left() const;
    /// Is the path, after its first shortcuts, too far from the best one to be worth more?
    bool hopeless() const;
    /// Is the best path as good as it gets?
    bool optimal() const { return best_cost_ <= options_.good_enough; }
    /// Is the work spent, the time up, or the best path as good as it gets?
    bool finished() const;

  private:
    void note_best();

    PathShortener& shortener_;
    const ImproveOptions& options_;
    double end_of_work_;
    Configurations path_, best_path_;
    double cost_ = 0, best_cost_;
};

/// What improvement needs to know of a body: how its paths are shortened and what that takes.
class PathShortener {
  public:
    virtual ~PathShortener() = default;

    /// Of a path, in the body's own cost.
    virtual double cost(const Configurations& path) = 0;
    /// Done so far by this shortener, microseconds as in ImproveOptions::work.
    virtual double work() const = 0;
    /// Shortens the path until nothing gains any more or the improvement is finished.
    virtual void shorten(Improvement& improvement, Rng& rng) = 0;
    /// Improves the best path by what the present one and an earlier one give together, where the
    /// body can do that.
    virtual void cross(const Configurations& earlier, Improvement& improvement, Rng& rng) = 0;
};

/// Shortens a path; once that gains nothing more, does the same with other paths, and crosses each
/// with the best one (restart and shortcut: Luna, Şucan, Moll and Kavraki, 2013; hybridisation:
/// Raveh, Enosh and Halperin, 2011). Where searches for other paths fail, they get more time. Ends
/// before the work is spent or the time is up only with a path that is as good as it gets. Returns
/// the best path.
Configurations improve(Configurations path, PathShortener& shortener, const ImproveOptions& options,
                       Rng& rng);

}  // namespace asv::core
