#include "core/generate/vouch/proven_motions.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/shapes/flat_chain.hpp"

namespace asv::core {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// The planner's margin is ten times that; the chains here follow straight lines in the corridors.
constexpr Margins narrow_margins{.length = 1e-6};

double nearest_turn(double heading, double reference) {
    return heading + two_pi * std::round((reference - heading) / two_pi);
}

}  // namespace

ProvenMotions::ProvenMotions(const Problem& problem)
    : problem_(problem),
      chain_(problem.asv_count(), problem.requirements.broom_length, Anchor::centroid),
      constraints_(make_constraints(problem_, chain_, narrow_margins)),
      field_(constraints_.obstacles),
      checker_(chain_, constraints_, field_),
      diameter_(round_diameter(problem.asv_count(), problem.requirements)),
      map_(problem_, diameter_ / 2) {}

ProvenMotions::Row ProvenMotions::row(const std::vector<Point>& positions,
                                      double heading_near) const {
    Row row(chain_.dimension());
    chain_.configuration(positions, row);
    row[2] = nearest_turn(row[2], heading_near);
    // Joints on a straight rail turn by plus or minus a rounding error; no turn may be negative.
    for (std::size_t i = 3; i < row.size(); ++i) {
        if (row[i] < 0 && row[i] > -1e-9) row[i] = 0;
    }
    return row;
}

std::optional<BentChain> ProvenMotions::bent_round(const Row& row) {
    constexpr std::size_t max_nodes = 80;
    Row round(chain_.dimension(), two_pi / static_cast<double>(asv_count()));
    for (const std::uint32_t node : map_.near({row[0], row[1]}, 2 * diameter_, max_nodes)) {
        const Point place = map_.place(node);
        for (const double turned : {0.0, 0.5, -0.5}) {
            round[0] = place.x;
            round[1] = place.y;
            round[2] = row[2] + turned;
            if (checker_.valid(row, round)) return BentChain{node, {row, round}};
        }
    }
    return std::nullopt;
}

bool ProvenMotions::append(WayPoints& rows, Row next) {
    next[2] = nearest_turn(next[2], rows.back()[2]);
    if (!checker_.valid(rows.back(), next)) return false;
    rows.push_back(std::move(next));
    return true;
}

bool ProvenMotions::append_all(WayPoints& rows, const WayPoints& more) {
    for (const Row& row : more) {
        if (!append(rows, row)) return false;
    }
    return true;
}

bool ProvenMotions::append_route(WayPoints& rows, std::uint32_t from, std::uint32_t to) {
    for (const Point& corner : map_.route(from, to)) {
        Row next = rows.back();
        next[0] = corner.x;
        next[1] = corner.y;
        if (!append(rows, std::move(next))) return false;
    }
    return true;
}

}  // namespace asv::core
