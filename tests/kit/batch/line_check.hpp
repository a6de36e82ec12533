#pragma once

#include <span>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"

namespace asv::test {

/// Proves straight lines in the space of configurations valid, eight stretches at a time: what is
/// not certified and not refuted in its middle is cut into shorter stretches (adaptive dynamic
/// collision checking, Schwarzer, Saha and Latombe, 2005). Holds scratch memory: one object for
/// each thread.
class LineCheck {
  public:
    /// The batch must outlive it.
    explicit LineCheck(core::batch::ChainBatch& batch) : batch_(batch) {}

    /// Is every configuration from + t * step, 0 <= t <= 1, valid? A yes is a proof. A no means
    /// that one is not, or that a stretch not longer than the resolution, in t, is too close to a
    /// limit to tell. Preconditions: rows as for ChainBatch::certify; resolution > 0.
    bool valid(std::span<const double> from, std::span<const double> step, double resolution);

    /// The line is proven valid for 0 <= t <= result: 1 for the whole line, 0 when not even its
    /// beginning is proven. What blocks it begins within the next resolution.
    double valid_prefix(std::span<const double> from, std::span<const double> step,
                        double resolution);

  private:
    struct Stretch {
        double begin, end;
    };

    double prove(core::batch::Stretches& line, double resolution, bool whole);
    void cut(const Stretch& stretch, std::size_t pieces);
    void take(core::batch::Stretches& line);

    core::batch::ChainBatch& batch_;
    std::vector<Stretch> open_;   ///< not yet judged, the earliest last
    std::vector<Stretch> taken_;  ///< those of this round, in order
};

}  // namespace asv::test
