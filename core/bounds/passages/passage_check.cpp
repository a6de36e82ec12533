#include "core/bounds/passages/passage_check.hpp"

#include <string>
#include <utility>

#include "core/bounds/chain_limits.hpp"
#include "core/bounds/passages/cells/chain_cells.hpp"

namespace asv::core {

namespace {

/// Gates are looked for among all pairs of obstacles, which are too many beyond this.
constexpr std::size_t most_obstacles = 1000;

bool applies_to(const Problem& problem) {
    const std::size_t n = problem.asv_count();
    return problem.body_kind() == BodyKind::chain && n >= 3 && n <= most_asvs_in_cells &&
           problem.obstacles.size() <= most_obstacles && keeps_orientation(problem);
}

}  // namespace

PassageCheck::PassageCheck(const Problem& problem) {
    if (!applies_to(problem)) return;
    turned_ = turned_left(problem);
    gates_.emplace(turned_);
}

Feasibility PassageCheck::work(std::size_t cells) {
    if (gates_) {
        gates_->work(cells);
        if (gates_->proven()) return std::exchange(gates_, std::nullopt)->conclusion();
        if (!gates_->finished()) return {};
        turns_.emplace(turned_.problem, gates_->closed());
        gates_.reset();
    }
    if (turns_) {
        turns_->work(cells);
        if (turns_->proven()) return no_room_to_turn();
        if (turns_->finished()) turns_.reset();
    }
    return {};
}

Feasibility PassageCheck::no_room_to_turn() const {
    Feasibility found;
    found.cause = Infeasibility::no_room_to_turn;
    found.reason = "a chain of " + std::to_string(turned_.problem.asv_count()) +
                   " ASVs would have to turn where it has no room to";
    for (const Box& place : turns_->places_to_turn()) found.closed.push_back(turned_.back(place));
    return found;
}

}  // namespace asv::core
