#include "core/bounds/passages/cells/empty_region.hpp"

namespace asv::core {

EmptyRegion::EmptyRegion(const Problem& problem, const Box& middle, std::size_t most_cells)
    : cells_(problem, middle), waiting_{cells_.all()}, left_(most_cells) {}

EmptyRegion::EmptyRegion(const Problem& problem, const Box& middle, const BroomHeading& heading,
                         std::size_t most_cells)
    : cells_(problem, middle), waiting_(cells_.with_heading(heading)), left_(most_cells) {}

EmptyRegion::Answer EmptyRegion::examine(std::size_t& cells) {
    while (!waiting_.empty()) {
        if (left_ == 0) return Answer::may_not_be;
        if (cells == 0) return Answer::unknown;
        --left_;
        --cells;
        ChainCell& cell = waiting_.back();
        if (cells_.holds_no_state(cell)) {
            waiting_.pop_back();
            continue;
        }
        const auto halves = cells_.halves(cell);
        if (!halves) return Answer::may_not_be;
        waiting_.back() = halves->second;
        waiting_.push_back(halves->first);
    }
    return Answer::empty;
}

}  // namespace asv::core
