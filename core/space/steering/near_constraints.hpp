#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// One requirement gap(configuration) >= 0 that is near. For a broom and a box the gap is that
/// along one separating axis, which stays fixed.
struct NearConstraint {
    /// Point and corner: collisions, or bounds (a point without a box). All others are called as in
    /// ChainConstraints.
    enum class Kind {
        turn,
        point,
        corner,
        first_closing_turn,
        last_closing_turn,
        area,
        closing_side
    };
    Kind kind = Kind::turn;
    static constexpr std::size_t no_box = static_cast<std::size_t>(-1);
    std::size_t index = 0;     ///< broom, or turn
    std::size_t box = no_box;  ///< obstacle
    double fraction = 0;       ///< point: where on the broom, 0 or 1
    double nx = 0, ny = 0;     ///< point: axis away from what is near; corner: where it is
    double offset = 0;         ///< point: where along the axis that ends; corner: side of the broom

    /// Is this about the same broom and box as the other?
    bool same_pair(const NearConstraint& other) const {
        return box != no_box && box == other.box && index == other.index;
    }
    /// Is it, of those, along the same axis?
    bool same_axis(const NearConstraint& other) const {
        return kind == other.kind && nx == other.nx && ny == other.ny && offset == other.offset;
    }
};

/// Finds the requirements that are near a configuration and linearises them. Gradients are by the
/// heading coordinates [x, y of the anchor, heading of each broom], in which they are simplest.
/// Holds scratch memory.
class NearConstraints {
  public:
    NearConstraints(const Chain& chain, const ChainConstraints& constraints,
                    const ObstacleField& field);

    /// All turns and all requirements of the shape, and what is within the radius of a broom or an
    /// ASV among obstacles and bounds. Valid until the next call.
    std::span<const NearConstraint> find(const Pose& pose, double radius);

    /// The gap of the constraint at a configuration and its pose.
    double gap(const NearConstraint& near, std::span<const double> row, const Pose& pose) const;

    /// Fills out with the gap's derivatives; out.size() == dimension of the chain.
    void gradient(const NearConstraint& near, const Pose& pose, std::span<double> out) const;

    /// Fills out with the derivatives of (nx, ny) . (point at that fraction of the broom).
    void point_gradient(std::size_t broom, double fraction, double nx, double ny, const Pose& pose,
                        std::span<double> out) const;

  private:
    void near_boxes(const Pose& pose, double radius);
    void near_box(std::size_t broom, std::size_t index, const geometry::Box& box, const Pose& pose,
                  double radius);
    void near_bounds(const Pose& pose, double radius);
    void closing_turn_gradient(std::size_t end, double sign, const Pose& pose,
                               std::span<double> by_heading) const;
    void area_gradient(const Pose& pose, std::span<double> by_heading) const;
    void closing_side_gradient(const Pose& pose, std::span<double> by_heading) const;

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const ObstacleField& field_;
    std::vector<NearConstraint> near_;
};

}  // namespace asv::core
