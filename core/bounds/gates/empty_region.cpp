#include "core/bounds/gates/empty_region.hpp"

#include <utility>

namespace asv::core {

EmptyRegion::EmptyRegion(const Problem& problem, const Box& middle)
    : cells_(problem, middle), waiting_{cells_.all()} {}

EmptyRegion::Answer EmptyRegion::examine(std::size_t& cells) {
    while (!waiting_.empty()) {
        if (cells == 0) return Answer::unknown;
        --cells;
        ChainCell& cell = waiting_.back();
        if (cells_.holds_no_state(cell)) {
            waiting_.pop_back();
            continue;
        }
        auto halves = cells_.halves(cell);
        if (!halves) return Answer::may_not_be;
        waiting_.back() = halves->second;
        waiting_.push_back(halves->first);
    }
    return Answer::empty;
}

}  // namespace asv::core
