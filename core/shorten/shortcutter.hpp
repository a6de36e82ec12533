#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/proof/motion_checker.hpp"

namespace asv::core {

/// How two places of a path may be joined anew: appends the rows that lead from the first to the
/// second (the second one included) and says whether they get there.
using Bridge = std::function<bool(std::span<const double> from, std::span<const double> to,
                                  Configurations& between)>;

/// Tries to shorten a path and returns whether it did: two random places, even in cost, are joined
/// anew by the bridge; what is cheaper replaces what was between them (Geraerts and Overmars, 2007,
/// in the cost that counts: the distances of the ASVs). The path keeps its ends and its validity.
class Shortcutter {
  public:
    /// What a straight motion costs: not negative, and as much for its parts together.
    using Cost = std::function<double(std::span<const double> from, std::span<const double> to)>;

    Shortcutter(std::size_t dimension, Cost cost, Configurations path);
    /// In the cost of a chain of ASVs.
    Shortcutter(const Chain& chain, Configurations path)
        : Shortcutter(chain.dimension(), MotionCost(chain), std::move(path)) {}

    const Configurations& path() const { return path_; }
    double cost() const { return cumulative_.back(); }

    /// One attempt with the places' distance up to the given share of the whole path.
    bool attempt(const Bridge& bridge, double max_share, Rng& rng);

    /// What tells whether a straight motion is valid.
    using MotionValid =
        std::function<bool(std::span<const double> from, std::span<const double> to)>;

    /// The same for some coordinates alone, `count` from `first` on: they go straight from place to
    /// place, as far as the path has come at each way point, and the others stay as they are
    /// (partial shortcut).
    bool attempt_partial(std::size_t first, std::size_t count, const MotionValid& valid,
                         double max_share, Rng& rng);

  private:
    struct Place {
        std::size_t after;  ///< way point before the place
        double fraction;
    };
    Place at(double cost) const;
    std::span<const double> row(std::size_t way_point) const {
        return {path_.data() + way_point * dimension_, dimension_};
    }
    void configuration(const Place& place, std::vector<double>& row) const;
    void measure(std::span<const double> known_first, std::span<const double> known_last);
    bool choose(double max_share, Rng& rng);
    bool gains();
    void replace();

    std::size_t dimension_;
    Cost motion_cost_;
    Configurations path_;
    std::vector<double> costs_;       ///< of each motion
    std::vector<double> cumulative_;  ///< at each way point
    Place first_{}, last_{};          ///< the places to be joined
    bool from_start_ = false, to_goal_ = false;
    std::vector<double> from_, to_;  ///< their configurations
    Configurations between_;         ///< what leads from the first to the second
};

}  // namespace asv::core
