#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/generate/vouch/round_map.hpp"
#include "core/model/problem.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// Way points that end with the round chain (bent to a regular polygon) at a node of the map.
struct BentChain {
    std::uint32_t node;
    std::vector<std::vector<double>> way_points;
};

/// Builds lists of way points, configurations of a chain anchored at its centroid, of which every
/// two neighbours are joined by a straight motion that is proven valid.
class ProvenMotions {
  public:
    using Row = std::vector<double>;
    using WayPoints = std::vector<Row>;

    /// Precondition: start and goal are valid and counter-clockwise.
    explicit ProvenMotions(const Problem& problem);
    ProvenMotions(const ProvenMotions&) = delete;
    ProvenMotions& operator=(const ProvenMotions&) = delete;

    const Problem& problem() const { return problem_; }
    const RoundMap& map() const { return map_; }
    std::size_t asv_count() const { return chain_.asv_count(); }
    double broom_length() const { return chain_.broom_length(); }
    /// Diameter of the round chain.
    double diameter() const { return diameter_; }

    /// The configuration at these positions, its heading within pi of the other one.
    Row row(const std::vector<Point>& positions, double heading_near) const;

    bool valid(const Row& row) { return checker_.valid(row); }
    bool valid(const Row& from, const Row& to) { return checker_.valid(from, to); }
    std::uint64_t checks() const { return checker_.motion_checks(); }

    /// The straight motion from a configuration to the round chain at some node nearby; nothing
    /// where none of those tried is valid.
    std::optional<BentChain> bent_round(const Row& row);

    /// Appends a way point, turned by full turns to the last one's heading; false, and nothing
    /// appended, when the motion to it is not valid. Precondition: rows is not empty.
    bool append(WayPoints& rows, Row next);
    /// Appends way points one after the other until one fails.
    bool append_all(WayPoints& rows, const WayPoints& more);
    /// Moves the round chain from one node to another of the same component.
    bool append_route(WayPoints& rows, std::uint32_t from, std::uint32_t to);

  private:
    Problem problem_;
    Chain chain_;
    ChainConstraints constraints_;
    ObstacleField field_;
    MotionChecker checker_;
    double diameter_;
    RoundMap map_;
};

}  // namespace asv::core
