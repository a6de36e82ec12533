#pragma once

#include "core/search/search_result.hpp"

namespace asv::core {

/// Extension 2: the trees change roles only after a connect that ended in a collision. The tree
/// that gets everywhere it wants to keeps growing.
class CollisionSwap {
  public:
    explicit CollisionSwap(bool on) : on_(on) {}

    /// Tells of a growth.
    void grown(Steered outcome) { collided_ = collided_ || outcome != Steered::reached; }

    bool due() {
        const bool swap = !on_ || collided_;
        collided_ = false;
        return swap;
    }

  private:
    bool on_, collided_ = false;
};

}  // namespace asv::core
