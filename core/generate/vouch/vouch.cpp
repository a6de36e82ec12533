#include "core/generate/vouch/vouch.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/bounds/feasibility.hpp"
#include "core/generate/vouch/gate_passage.hpp"
#include "core/generate/vouch/proven_motions.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

using Row = ProvenMotions::Row;
using WayPoints = ProvenMotions::WayPoints;

/// The passages to take one after the other, from one component of the map to another, as few as
/// possible, each in the right direction.
std::optional<std::vector<GatePassage>> passages_between(ProvenMotions& motions, std::uint32_t from,
                                                         std::uint32_t to) {
    std::vector<GatePassage> known = gate_passages(motions);
    for (std::size_t i = 0, count = known.size(); i < count; ++i) {
        known.push_back(known[i]);
        known.back().reverse();
    }
    // Breadth first from the far end: the next passage from each component that leads there.
    std::map<std::uint32_t, const GatePassage*> next;
    std::vector<std::uint32_t> queue{to};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (const GatePassage& passage : known) {
            const std::uint32_t before = motions.map().component(passage.left);
            if (motions.map().component(passage.right) == queue[i] && before != to &&
                next.emplace(before, &passage).second)
                queue.push_back(before);
        }
    }
    std::vector<GatePassage> way;
    while (from != to) {
        const auto found = next.find(from);
        if (found == next.end()) return std::nullopt;
        way.push_back(*found->second);
        from = motions.map().component(way.back().right);
    }
    return way;
}

/// Leads from the round chain at one node to that at another; how many passages it takes, or
/// nothing where no way is found.
std::optional<std::size_t> append_way(ProvenMotions& motions, WayPoints& rows, std::uint32_t from,
                                      std::uint32_t to) {
    const RoundMap& map = motions.map();
    std::vector<GatePassage> passages;
    if (map.component(from) != map.component(to)) {
        auto found = passages_between(motions, map.component(from), map.component(to));
        if (!found) return std::nullopt;
        passages = std::move(*found);
    }
    for (const GatePassage& passage : passages) {
        if (!motions.append_route(rows, from, passage.left) ||
            !motions.append_all(rows, passage.way_points))
            return std::nullopt;
        from = passage.right;
    }
    if (!motions.append_route(rows, from, to)) return std::nullopt;
    return passages.size();
}

Verdict unknown(std::string reason) {
    Verdict verdict;
    verdict.reason = std::move(reason);
    return verdict;
}

Verdict verdict_on(ProvenMotions& motions) {
    const Row start = motions.row(motions.problem().start, 0);
    const Row goal = motions.row(motions.problem().goal, start[2]);
    if (motions.valid(start, goal))
        return {true, "the straight motion from start to goal is free", {start, goal}, false};
    const auto first = motions.bent_round(start);
    const auto last = motions.bent_round(goal);
    if (!first || !last)
        return unknown(std::string("the ") + (first ? "goal" : "start") +
                       " does not bend to a regular polygon nearby by one straight motion");
    WayPoints rows = first->way_points;
    const auto passages = append_way(motions, rows, first->node, last->node);
    if (!passages ||
        !motions.append_all(rows, {last->way_points.rbegin(), last->way_points.rend()}))
        return unknown(
            "no way for the chain bent to a regular polygon, and no corridor that it threads by "
            "proven motions");
    std::string reason = "the chain bent to a regular polygon moves through free space";
    if (*passages > 0)
        reason += " and threads corridors by proven motions: " + std::to_string(*passages);
    return {true, reason, std::move(rows), false};
}

}  // namespace

Verdict vouch(const Problem& problem) {
    if (problem.asv_count() < 3) return unknown("a lone ASV does not bend to a regular polygon");
    if (Feasibility found = check_orientation(problem); found.cause != Infeasibility::none)
        return unknown(std::move(found.reason));
    Problem counter_clockwise = problem;
    const bool reversed = geometry::signed_area(problem.start) < 0;
    if (reversed) {
        std::reverse(counter_clockwise.start.begin(), counter_clockwise.start.end());
        std::reverse(counter_clockwise.goal.begin(), counter_clockwise.goal.end());
    }
    ProvenMotions motions(counter_clockwise);
    Verdict verdict = verdict_on(motions);
    verdict.reversed = reversed;
    return verdict;
}

}  // namespace asv::core
