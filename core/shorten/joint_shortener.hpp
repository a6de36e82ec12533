#pragma once

#include <cstddef>
#include <cstdint>

#include "core/shorten/improve.hpp"
#include "core/space/joint_space.hpp"

namespace asv::core {

/// Microseconds of a 2.8 GHz core, roughly, that so many checks take in a joint space of so many
/// dimensions.
double microseconds(std::uint64_t state_checks, std::uint64_t motion_checks, std::size_t dimension);

/// What all motions of a path cost.
double path_cost(const JointSpace& space, const Configurations& path);

/// Shortens the paths of an arm or a point by straight shortcuts.
class JointShortener : public PathShortener {
  public:
    /// The space outlives the shortener.
    explicit JointShortener(JointSpace& space) : space_(space) {}

    double cost(const Configurations& path) override { return path_cost(space_, path); }
    double work() const override;
    void shorten(Improvement& improvement, Rng& rng) override;
    /// Does nothing: the straight shortcuts of an arm leave little to be gained by crossing.
    void cross(const Configurations&, Improvement&, Rng&) override {}

  private:
    JointSpace& space_;
};

}  // namespace asv::core
