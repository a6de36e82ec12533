#include "core/space/proof/batch_checker.hpp"

#include <algorithm>
#include <numbers>

namespace asv::core {

namespace {

batch::ChainLimits limits_of(const Chain& chain, const ChainConstraints& constraints) {
    batch::ChainLimits limits;
    limits.link = chain.broom_length();
    limits.bounds = constraints.bounds;
    limits.min_area = constraints.min_area;
    limits.min_first_closing_turn = constraints.min_first_closing_turn;
    limits.min_last_closing_turn = constraints.min_last_closing_turn;
    limits.min_closing_side = constraints.min_closing_side;
    limits.min_turn = constraints.min_turn;
    limits.max_turn = constraints.max_turn;
    // Nothing is asked of the total turn but what the closing turns ask.
    limits.max_total_turn = std::numbers::pi * static_cast<double>(chain.asv_count());
    limits.anchor_lever.assign(chain.anchor_lever().begin(), chain.anchor_lever().end());
    return limits;
}

}  // namespace

BatchChecker::BatchChecker(const Chain& chain, const ChainConstraints& constraints,
                           const ObstacleField& field)
    : chain_(chain),
      limits_(limits_of(chain, constraints)),
      batch_(chain.broom_count(), limits_, field.index()),
      from_(chain.dimension()),
      step_(chain.dimension()) {
    for (std::size_t lane = 0; lane < batch::lanes; ++lane) {
        middle_[lane] = (0.5 + static_cast<double>(lane)) / batch::lanes;
        // The rounding of the moments must not open a crack between neighbours.
        half_length_[lane] = 0.5 / batch::lanes + 0x1p-50;
    }
}

BatchChecker::Verdict BatchChecker::motion(std::span<const double> from,
                                           std::span<const double> to) {
    ++looks_;
    for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = to[i] - from[i];
    // Each heading takes the place of the coordinate that it is summed up from.
    const auto beyond_place = [](std::vector<double>& row) { return std::span(row).subspan(2); };
    chain_.headings(step_, beyond_place(step_));
    std::copy_n(from.begin(), 2, from_.begin());
    chain_.headings(from, beyond_place(from_));
    const auto [certified, midpoint_valid] = batch_.certify({from_, step_, middle_, half_length_});
    if (midpoint_valid != batch::all_lanes) return Verdict::blocked;
    return certified == batch::all_lanes ? Verdict::valid : Verdict::open;
}

}  // namespace asv::core
