#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/shorten/band/block_tridiagonal.hpp"
#include "core/shorten/band/way_points.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/steering/near_constraints.hpp"

namespace asv::core {

/// The requirements that are near the way points of a path, as contacts that push back: a
/// primal-dual interior-point method (Mehrotra, 1992; here with soft constraints). Each contact has
/// a slack > 0, how far its gap is above its margin, and a force > 0; their product is driven to a
/// barrier parameter that falls from step to step. Holds scratch memory.
class Contacts {
  public:
    explicit Contacts(const MotionChecker& checker);

    /// Finds what is within reach of the way points; all slacks and forces start anew, in balance
    /// at the barrier.
    void find(const WayPoints& path, double reach, double barrier);

    /// Adds what the contacts do at the present way points to the system and the force.
    void press(const WayPoints& path, double barrier, BlockTridiagonal& system,
               std::span<double> force);

    /// Lets slacks and forces follow the step that the way points take, in heading coordinates.
    void follow(std::span<const double> step);

  private:
    struct Contact {
        NearConstraint near;
        std::size_t node;
        double unit;  ///< that makes its gap a length
        double slack, force;
        double lack = 0;   ///< by which gap - margin misses the slack
        double rest = 0;   ///< change of the force were the way point to stay
        double stiff = 0;  ///< how the force gives way to the way point's step
    };

    void add(const WayPoints& path, const NearConstraint& near, std::size_t node, double barrier);
    void add_switches(const WayPoints& path, std::size_t node, double barrier);
    double dip(const WayPoints& path, const NearConstraint& near, std::size_t node,
               double gap) const;
    std::span<double> gradient(std::size_t contact) {
        return {gradients_.data() + contact * dimension_, dimension_};
    }

    std::size_t dimension_;
    NearConstraints near_;
    std::vector<Contact> contacts_;
    std::vector<std::size_t> first_;  ///< contact of each way point
    std::vector<double> gradients_;
};

}  // namespace asv::core
