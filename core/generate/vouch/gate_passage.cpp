#include "core/generate/vouch/gate_passage.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/generate/vouch/gate.hpp"
#include "core/shapes/flat_chain.hpp"

namespace asv::core {

namespace {

using Row = ProvenMotions::Row;
using WayPoints = ProvenMotions::WayPoints;

constexpr std::size_t max_obstacles = 64;
constexpr std::uint64_t max_checks = 400'000;
// Fine enough for the tightest corridors, coarse enough to give up soon.
constexpr double longest_advance = 0.01;
constexpr double shortest_advance = 2e-5;
// Rails to try: lengths of the upright legs, and how far they stand from the mouths.
constexpr std::array legs{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6};
constexpr std::array distances{0.0, 0.03, 0.06, 0.08, 0.13, 0.18, 0.24, 0.3};

/// From the chain's state on a rail, by way of a shift away from the gate (towards +x or -x), to
/// the round chain nearby, where that is possible.
std::optional<BentChain> bent_from_rail(ProvenMotions& motions, const GateRail& rail,
                                        double advance, double away) {
    const auto chain = chain_on_rail(rail, motions.asv_count(), motions.broom_length(), advance);
    if (chain.empty()) return std::nullopt;
    const Row row = motions.row(chain, 0);
    if (!motions.valid(row)) return std::nullopt;
    for (const double shift : {0.0, 0.03, 0.08, 0.15}) {
        Row shifted = row;
        shifted[0] += away * shift;
        if (!motions.valid(row, shifted)) return std::nullopt;
        if (auto bent = motions.bent_round(shifted)) {
            bent->way_points.insert(bent->way_points.begin(), row);
            return bent;
        }
    }
    return std::nullopt;
}

/// Appends the states on the rail up to an advance, as far apart as the proofs succeed.
bool append_advance(ProvenMotions& motions, WayPoints& rows, const GateRail& rail,
                    const RailSpan& span) {
    double at = span.enter;
    double step = longest_advance;
    while (at < span.leave) {
        const double next = std::min(span.leave, at + step);
        const auto chain = chain_on_rail(rail, motions.asv_count(), motions.broom_length(), next);
        if (!chain.empty() && motions.append(rows, motions.row(chain, rows.back()[2]))) {
            at = next;
            step = std::min(longest_advance, 2 * step);
        } else if ((step /= 2) < shortest_advance) {
            return false;
        }
    }
    return true;
}

std::optional<GatePassage> passage_on_rail(ProvenMotions& motions, const GateRail& rail,
                                           const BentChain& before, const BentChain& after) {
    const RailSpan span = rail_span(rail, motions.asv_count(), motions.broom_length());
    GatePassage passage{
        before.node, after.node, {before.way_points.rbegin(), before.way_points.rend()}};
    if (!append_advance(motions, passage.way_points, rail, span) ||
        !motions.append_all(passage.way_points, after.way_points))
        return std::nullopt;
    return passage;
}

/// Tries all rails with the leg; the end states depend on the distance on their own side alone.
std::optional<GatePassage> passage_with_leg(ProvenMotions& motions, const GateRail& likeness) {
    std::array<std::optional<BentChain>, distances.size()> before, after;
    GateRail rail = likeness;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        rail.distance_before = rail.distance_after = distances[i];
        const RailSpan span = rail_span(rail, motions.asv_count(), motions.broom_length());
        before[i] = bent_from_rail(motions, rail, span.enter, -1);
        after[i] = bent_from_rail(motions, rail, span.leave, +1);
    }
    for (std::size_t i = 0; i < distances.size(); ++i) {
        for (std::size_t k = 0; k < distances.size(); ++k) {
            if (!before[i] || !after[k] || motions.checks() > max_checks) continue;
            rail.distance_before = distances[i];
            rail.distance_after = distances[k];
            if (auto found = passage_on_rail(motions, rail, *before[i], *after[k])) return found;
        }
    }
    return std::nullopt;
}

std::optional<GatePassage> passage(ProvenMotions& motions, const Gate& gate) {
    const double flat = min_flat_height(motions.asv_count(), motions.problem().requirements);
    const double slack = (gate.height() > flat ? gate.height() - flat : gate.height()) / 4;
    for (const bool mirrored : {false, true}) {
        for (const double leg : legs) {
            if (motions.checks() > max_checks) return std::nullopt;
            if (auto found = passage_with_leg(motions, {gate, mirrored, 0, 0, leg, slack}))
                return found;
        }
    }
    return std::nullopt;
}

}  // namespace

void GatePassage::reverse() {
    std::swap(left, right);
    std::reverse(way_points.begin(), way_points.end());
}

std::vector<GatePassage> gate_passages(ProvenMotions& motions) {
    std::vector<GatePassage> found;
    const auto& obstacles = motions.problem().obstacles;
    if (obstacles.size() > max_obstacles) return found;
    for (const Gate& gate : find_gates(obstacles, motions.diameter())) {
        if (auto way = passage(motions, gate)) found.push_back(std::move(*way));
    }
    return found;
}

}  // namespace asv::core
