#include "tests/core/certificate_check/certificate_kit.hpp"

#include <algorithm>
#include <numeric>

#include "core/certificate_check/strip_area.hpp"

namespace asv::test {

namespace {

using core::Box;
using core::ClosedCorridor;
using core::ClosedSeam;
using core::FacingWalls;
using core::Problem;

constexpr double far_away = 100;

/// The walls as boxes, the first one to the left of the second; the border is a large one.
std::array<Box, 2> boxes_of(const Problem& problem, const FacingWalls& facing) {
    const Box& bounds = problem.requirements.bounds;
    std::array<Box, 2> boxes{geometry::grown(bounds, far_away), geometry::grown(bounds, far_away)};
    boxes[0].high = bounds.low;
    boxes[1].low = bounds.high;
    if (facing.upright) {
        boxes[0].high.y = boxes[1].high.y;
        boxes[1].low.y = boxes[0].low.y;
    } else {
        boxes[0].high.x = boxes[1].high.x;
        boxes[1].low.x = boxes[0].low.x;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (facing.walls[i]) boxes[i] = problem.obstacles.at(*facing.walls[i]);
        if (!facing.upright) boxes[i] = geometry::transposed(boxes[i]);
    }
    return boxes;
}

}  // namespace

core::CertificateVerdict check(const core::InfeasibilityProof& proof, const Problem& problem) {
    return check_certificate({core::certified(problem, "digest"), proof}, problem, "digest");
}

std::string failures(const core::CertificateVerdict& verdict) {
    std::string names;
    for (const core::CheckedClaim& claim : verdict.claims)
        if (!claim.holds) names.append(names.empty() ? "" : ", ").append(claim.claim);
    return names;
}

std::vector<std::size_t> all_obstacles(const Problem& problem) {
    std::vector<std::size_t> all(problem.obstacles.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

ClosedSeam seam(const Problem& problem, const FacingWalls& facing) {
    const core::Requirements& r = problem.requirements;
    const auto [left, right] = boxes_of(problem, facing);
    const double shrink = r.tolerance + (r.max_step + r.tolerance) / 2;
    const auto shrink_of = [&](std::size_t i) { return facing.walls[i] ? shrink : r.tolerance; };
    const Box gap{{left.high.x - shrink_of(0), std::max(left.low.y, right.low.y) + shrink},
                  {right.low.x + shrink_of(1), std::min(left.high.y, right.high.y) - shrink}};
    return {facing, facing.upright ? gap : geometry::transposed(gap),
            right.low.x - left.high.x + 2 * r.tolerance, gap.high.y - gap.low.y};
}

ClosedCorridor corridor(const Problem& problem, const FacingWalls& facing) {
    using core::certificate_check::exact;
    const core::Requirements& r = problem.requirements;
    const auto [left, right] = boxes_of(problem, facing);
    const double broom = r.broom_length + r.tolerance;
    const double chain = broom * static_cast<double>(problem.asv_count() - 1);
    const double mouth = r.tolerance + (chain + r.max_step + r.tolerance) / 2;
    const double height = right.low.x - left.high.x;
    ClosedCorridor corridor{facing, std::max(left.low.y, right.low.y) + mouth,
                            std::min(left.high.y, right.high.y) - mouth, height};
    // Without a length it needs no area.
    if (corridor.from < corridor.to && height < r.broom_length)
        corridor.greatest_area =
            core::certificate_check::rounded(core::certificate_check::strip_area_at_most(
                problem.asv_count(), exact(broom), exact(height + 2 * r.tolerance),
                core::certificate_check::rows_of_statements));
    return corridor;
}

core::CorridorProof corridor_proof(const Problem& problem, std::vector<ClosedCorridor> corridors) {
    const core::Requirements& r = problem.requirements;
    return {r.tolerance + (r.max_step + r.tolerance) / 2,
            r.min_area(problem.asv_count()) - r.tolerance, all_obstacles(problem),
            std::move(corridors)};
}

std::vector<ClosedCorridor> all_corridors(const Problem& problem) {
    std::vector<ClosedCorridor> found;
    const std::size_t count = problem.obstacles.size();  // which is also the border's number
    for (std::size_t i = 0; i <= count; ++i) {
        for (std::size_t j = 0; j <= count; ++j) {
            for (const bool upright : {false, true}) {
                if (i == j) continue;
                FacingWalls facing{{i, j}, upright};
                for (auto& wall : facing.walls)
                    if (*wall == count) wall.reset();
                const ClosedCorridor one = corridor(problem, facing);
                const double longest = problem.requirements.broom_length;
                if (one.from < one.to && one.height > 0 && one.height < longest)
                    found.push_back(one);
            }
        }
    }
    return found;
}

}  // namespace asv::test
