#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"
#include "core/chain/chain.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// Looks at a motion in one go: eight stretches of it at once, one to a SIMD lane
/// (batch::ChainBatch). That costs about as much as one moment of MotionChecker and
/// settles most of the long motions of a roadmap; what it leaves open takes MotionChecker. The same
/// answers on every processor.
///
/// Holds scratch memory and refers to itself: one for each thread, which stays where it was made.
class BatchChecker {
  public:
    /// Preconditions: constraints.shaped, at least 3 ASVs; all three outlive it.
    BatchChecker(const Chain& chain, const ChainConstraints& constraints,
                 const ObstacleField& field);
    BatchChecker(const BatchChecker&) = delete;
    BatchChecker& operator=(const BatchChecker&) = delete;

    enum class Verdict {
        valid,    ///< every configuration on the line is: proven
        blocked,  ///< one of those in the middles of the stretches is invalid
        open      ///< neither is known
    };

    /// Of the straight line in C-space. It keeps about 2e-6 of the coordinates' size from obstacles
    /// and 1e-12 from other limits, so that MotionChecker proves whatever this proves.
    Verdict motion(std::span<const double> from, std::span<const double> to);

    /// Looks taken, eight configurations each.
    std::uint64_t looks() const { return looks_; }

  private:
    const Chain& chain_;
    batch::ChainLimits limits_;
    batch::ChainBatch batch_;
    geometry::simd::Pack middle_, half_length_;  ///< of the stretches
    std::vector<double> from_, step_;            ///< place and headings, not turns
    std::uint64_t looks_ = 0;
};

}  // namespace asv::core
