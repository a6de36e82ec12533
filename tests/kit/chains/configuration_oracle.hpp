#pragma once

#include <span>

#include "core/space/chain_world.hpp"
#include "tests/kit/chains/configurations.hpp"

namespace asv::test {

/// A judge of configurations and motions that shares no code with the planner's: the limits that
/// the planner has set itself by formulas written anew, the requirements by the validator.
class Oracle {
  public:
    /// The world has to outlive the oracle.
    explicit Oracle(const core::ChainWorld& world) : world_(world) {}

    /// How far the configuration is from the nearest of the planner's limits; negative beyond one.
    /// In workspace units (turns times the length of a broom; area over it).
    double room(std::span<const double> row) const;

    struct Lowest {
        double room;
        double t;
    };
    /// The least room on the straight line, of so many samples and around the lowest of them.
    Lowest lowest(std::span<const double> from, std::span<const double> to,
                  std::size_t samples) const;

    /// Does the configuration pass the validator with its tolerance of 1e-5?
    bool judged_valid(std::span<const double> row) const;

    /// Longest way of an ASV between two configurations, as the crow flies.
    double moved(std::span<const double> a, std::span<const double> b) const;

    /// Asserts that all states of all motions between the rows are valid, with the planner's
    /// limits.
    void expect_valid_path(const std::vector<double>& rows, std::size_t samples = 60) const;

  private:
    double shape_room(const Points& points, std::span<const double> row) const;
    double outside_room(const Points& points) const;

    const core::ChainWorld& world_;
};

}  // namespace asv::test
