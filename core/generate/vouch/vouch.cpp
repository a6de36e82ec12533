#include "asv/core/generate/vouch/vouch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "asv/core/chain/chain.hpp"
#include "asv/core/generate/flat_chain.hpp"
#include "asv/core/generate/vouch/gate.hpp"
#include "asv/core/generate/vouch/round_map.hpp"
#include "asv/core/space/chain_constraints.hpp"
#include "asv/core/space/motion.hpp"
#include "asv/core/space/obstacle_field.hpp"
#include "asv/geometry/polygon.hpp"

namespace asv::core {

namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;

constexpr double two_pi = 2 * std::numbers::pi;

// Fine enough for the tightest corridors, coarse enough to give up soon.
constexpr double longest_advance = 0.01;
constexpr double shortest_advance = 2e-5;
constexpr std::uint64_t most_motion_checks = 400'000;

double nearest_turn(double heading, double reference) {
    return heading + two_pi * std::round((reference - heading) / two_pi);
}

Problem counter_clockwise(Problem problem, bool& reversed) {
    reversed = geometry::signed_area(problem.start) < 0;
    if (reversed) {
        std::reverse(problem.start.begin(), problem.start.end());
        std::reverse(problem.goal.begin(), problem.goal.end());
    }
    return problem;
}

/// Rows that end, or begin, with the round chain at a node of the map.
struct Bent {
    std::uint32_t node;
    Rows rows;
};

/// A proven way through a gate, from the round chain on its left to the round chain on its right.
struct Crossing {
    std::uint32_t left;
    std::uint32_t right;
    Rows rows;
};

class Voucher {
  public:
    explicit Voucher(const Problem& given)
        : problem_(counter_clockwise(given, reversed_)),
          chain_(problem_.asv_count(), problem_.requirements.broom_length, Anchor::centroid),
          // A tenth of the planner's margin: the chain follows a straight line in the corridors.
          constraints_(make_constraints(problem_, chain_, {.length = 1e-6})),
          field_(constraints_.boxes),
          checker_(chain_, constraints_, field_),
          map_(problem_, round_diameter(problem_.asv_count(), problem_.requirements) / 2) {}

    Verdict verdict();

  private:
    Row row_of(const std::vector<Point>& positions, double heading_near) const;
    Row round_row(const Point& place, double heading) const;
    std::optional<Bent> bent_round(const Row& row);
    bool append_route(Rows& rows, std::uint32_t from, std::uint32_t to);
    bool append_motion(Rows& rows, Row next);
    bool append_advance(Rows& rows, const GateRail& rail, double from, double to);
    std::optional<Bent> bent_from_rail(const GateRail& rail, double advance, double away);
    std::optional<Crossing> cross(const Gate& gate);
    std::optional<Crossing> cross(const GateRail& rail, const RailSpan& span, const Bent& first,
                                  const Bent& last);
    std::vector<Crossing> crossings();
    bool append_crossings(Rows& rows, std::uint32_t from, std::uint32_t to, std::size_t& count);

    bool reversed_ = false;
    Problem problem_;
    Chain chain_;
    ChainConstraints constraints_;
    ObstacleField field_;
    MotionChecker checker_;
    RoundMap map_;
};

Row Voucher::row_of(const std::vector<Point>& positions, double heading_near) const {
    Row row(chain_.dimension());
    chain_.configuration(positions, row);
    row[2] = nearest_turn(row[2], heading_near);
    // Joints on a straight rail turn by plus or minus a rounding error; no turn may be negative.
    for (std::size_t i = 3; i < row.size(); ++i) {
        if (row[i] < 0 && row[i] > -1e-9) row[i] = 0;
    }
    return row;
}

Row Voucher::round_row(const Point& place, double heading) const {
    Row row(chain_.dimension(), two_pi / static_cast<double>(chain_.asv_count()));
    row[0] = place.x;
    row[1] = place.y;
    row[2] = heading;
    return row;
}

/// Bends the chain to the regular polygon on the straight way to some node nearby.
std::optional<Bent> Voucher::bent_round(const Row& row) {
    const double distance = 2 * round_diameter(chain_.asv_count(), problem_.requirements);
    for (const std::uint32_t node : map_.near({row[0], row[1]}, distance, 80)) {
        for (const double turned : {0.0, 0.5, -0.5}) {
            Row round = round_row(map_.place(node), row[2] + turned);
            if (checker_.valid(row, round)) return Bent{node, {row, std::move(round)}};
        }
    }
    return std::nullopt;
}

bool Voucher::append_motion(Rows& rows, Row next) {
    next[2] = nearest_turn(next[2], rows.back()[2]);
    if (!checker_.valid(rows.back(), next)) return false;
    rows.push_back(std::move(next));
    return true;
}

bool Voucher::append_route(Rows& rows, std::uint32_t from, std::uint32_t to) {
    for (const Point& corner : map_.route(from, to)) {
        if (!append_motion(rows, round_row(corner, rows.back()[2]))) return false;
    }
    return true;
}

/// Appends the states on the rail up to an advance, as far apart as the proofs succeed.
bool Voucher::append_advance(Rows& rows, const GateRail& rail, double from, double to) {
    double step = longest_advance;
    while (from < to) {
        const double next = std::min(to, from + step);
        const auto chain = chain_on_rail(rail, chain_.asv_count(), chain_.broom_length(), next);
        if (!chain.empty() && append_motion(rows, row_of(chain, rows.back()[2]))) {
            from = next;
            step = std::min(longest_advance, 2 * step);
        } else if ((step /= 2) < shortest_advance) {
            return false;
        }
    }
    return true;
}

/// The motion from the chain's state on a rail, away from the gate (towards +x or -x), to the round
/// chain nearby, where there is one.
std::optional<Bent> Voucher::bent_from_rail(const GateRail& rail, double advance, double away) {
    const auto chain = chain_on_rail(rail, chain_.asv_count(), chain_.broom_length(), advance);
    if (chain.empty()) return std::nullopt;
    const Row row = row_of(chain, 0);
    if (!checker_.valid(row)) return std::nullopt;
    for (const double shift : {0.0, 0.03, 0.08, 0.15}) {
        Row shifted = row;
        shifted[0] += away * shift;
        if (!checker_.valid(row, shifted)) return std::nullopt;
        if (auto bent = bent_round(shifted)) {
            bent->rows.insert(bent->rows.begin(), row);
            return bent;
        }
    }
    return std::nullopt;
}

/// Threads the gate along one rail. Both ends are states on the rail and what they bend to.
std::optional<Crossing> Voucher::cross(const GateRail& rail, const RailSpan& span,
                                       const Bent& first, const Bent& last) {
    Crossing crossing{first.node, last.node, {first.rows.rbegin(), first.rows.rend()}};
    if (!append_advance(crossing.rows, rail, span.enter, span.leave)) return std::nullopt;
    for (std::size_t i = 1; i < last.rows.size(); ++i) {
        if (!append_motion(crossing.rows, last.rows[i])) return std::nullopt;
    }
    return crossing;
}

std::optional<Crossing> Voucher::cross(const Gate& gate) {
    constexpr std::array legs{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6};
    constexpr std::array reaches{0.0, 0.03, 0.06, 0.08, 0.13, 0.18, 0.24, 0.3};
    const double flat = least_flat_height(chain_.asv_count(), problem_.requirements);
    const double slack = gate.height() > flat ? (gate.height() - flat) / 4 : gate.height() / 4;
    for (const bool mirrored : {false, true}) {
        for (const double leg : legs) {
            // The end states depend on the reach of their own side alone.
            std::array<std::optional<Bent>, reaches.size()> firsts, lasts;
            for (std::size_t i = 0; i < reaches.size(); ++i) {
                const GateRail rail{gate, mirrored, reaches[i], reaches[i], leg, slack};
                const RailSpan span = rail_span(rail, chain_.asv_count(), chain_.broom_length());
                firsts[i] = bent_from_rail(rail, span.enter, -1);
                lasts[i] = bent_from_rail(rail, span.leave, +1);
            }
            for (std::size_t i = 0; i < reaches.size(); ++i) {
                for (std::size_t k = 0; k < reaches.size(); ++k) {
                    if (!firsts[i] || !lasts[k]) continue;
                    if (checker_.motion_checks() > most_motion_checks) return std::nullopt;
                    const GateRail rail{gate, mirrored, reaches[i], reaches[k], leg, slack};
                    const RailSpan span =
                        rail_span(rail, chain_.asv_count(), chain_.broom_length());
                    if (auto found = cross(rail, span, *firsts[i], *lasts[k])) return found;
                }
            }
        }
    }
    return std::nullopt;
}

std::vector<Crossing> Voucher::crossings() {
    constexpr std::size_t most_obstacles = 64;
    std::vector<Crossing> found;
    if (problem_.obstacles.size() > most_obstacles) return found;
    const double diameter = round_diameter(chain_.asv_count(), problem_.requirements);
    for (const Gate& gate : find_gates(problem_.obstacles, diameter)) {
        if (auto crossing = cross(gate)) found.push_back(std::move(*crossing));
    }
    return found;
}

/// Leads from the round chain at one node to that at another, through gates where it must.
bool Voucher::append_crossings(Rows& rows, std::uint32_t from, std::uint32_t to,
                               std::size_t& count) {
    if (map_.component(from) == map_.component(to)) return append_route(rows, from, to);
    const std::vector<Crossing> known = crossings();
    // Breadth first over the components, from the goal's, so that the rows follow the pointers.
    std::map<std::uint32_t, std::pair<std::size_t, bool>> way;  // crossing, left to right
    std::vector<std::uint32_t> queue{map_.component(to)};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (std::size_t k = 0; k < known.size(); ++k) {
            for (const bool rightwards : {true, false}) {
                const auto [before, after] = rightwards ? std::pair(known[k].left, known[k].right)
                                                        : std::pair(known[k].right, known[k].left);
                const std::uint32_t component = map_.component(before);
                if (map_.component(after) != queue[i] || component == queue.front() ||
                    way.contains(component))
                    continue;
                way[component] = {k, rightwards};
                queue.push_back(component);
            }
        }
    }
    while (map_.component(from) != map_.component(to)) {
        const auto found = way.find(map_.component(from));
        if (found == way.end()) return false;
        const auto& [index, rightwards] = found->second;
        Crossing step = known[index];
        if (!rightwards) {
            std::reverse(step.rows.begin(), step.rows.end());
            std::swap(step.left, step.right);
        }
        if (!append_route(rows, from, step.left)) return false;
        for (Row& row : step.rows) {
            if (!append_motion(rows, std::move(row))) return false;
        }
        from = step.right;
        ++count;
    }
    return append_route(rows, from, to);
}

Verdict Voucher::verdict() {
    Verdict verdict;
    verdict.reversed = reversed_;
    const Row start = row_of(problem_.start, 0);
    const Row goal = row_of(problem_.goal, start[2]);
    if (checker_.valid(start, goal))
        return {true, "the straight motion from start to goal is free", {start, goal}, reversed_};
    const auto first = bent_round(start);
    const auto last = bent_round(goal);
    if (!first || !last) {
        verdict.reason = std::string("the ") + (first ? "goal" : "start") +
                         " does not bend to a regular polygon nearby by one straight motion";
        return verdict;
    }
    Rows rows = first->rows;
    std::size_t gates = 0;
    const bool found = append_crossings(rows, first->node, last->node, gates) &&
                       append_motion(rows, last->rows.back()) &&
                       append_motion(rows, last->rows.front());
    if (!found) {
        verdict.reason =
            "no way for the chain bent to a regular polygon, and no corridor that it threads by "
            "proven motions";
        return verdict;
    }
    verdict.solvable = true;
    verdict.way_points = std::move(rows);
    verdict.reason = "the chain bent to a regular polygon moves through free space";
    if (gates > 0)
        verdict.reason += " and threads corridors by proven motions: " + std::to_string(gates);
    return verdict;
}

}  // namespace

Verdict vouch(const Problem& problem) {
    return Voucher(problem).verdict();
}

}  // namespace asv::core
