#include "core/certificate_check/seam.hpp"

#include <algorithm>

namespace asv::core::certificate_check {

namespace {

void check_gap(const Box& stated, const Rectangle& found, const std::string& name, Claims& claims) {
    const bool same = agrees(stated.low.x, found.left) && agrees(stated.high.x, found.right) &&
                      agrees(stated.low.y, found.bottom) && agrees(stated.high.y, found.top);
    const std::string text = text_of(found.left) + " to " + text_of(found.right) + ", " +
                             text_of(found.bottom) + " to " + text_of(found.top);
    claims.add(name + ", gap", same, same ? text : "it is " + text);
}

}  // namespace

bool is_impassable(const Number& width, const Number& depth, const Problem& problem,
                   const Limits& limits) {
    const std::size_t n = limits.asv_count;
    const Number margin = exact(problem.requirements.broom_length) / 20;
    const Number inside = depth / 2 - limits.step / 2 - margin;
    const Number sine = std::max(Number(0), width) / margin;
    const Number off = limits.tolerance * n;  // of all turns that count as straight
    // Beyond that the angles are not small.
    if (n < 3 || inside < 0 || sine + off > exact(0.25)) return false;
    const std::size_t on_one_side = whole(inside / limits.broom) + 1;
    const std::size_t steep_brooms =
        std::min((n - 1) / 2, on_one_side) + std::min(n / 2, on_one_side);
    const Number row = limits.broom * steep_brooms;
    const Number tangent = sine / root_below(1 - sine * sine);
    const Number folded = 2 * limits.chain * limits.chain * (sine + off);
    const Number straight = (limits.chain * limits.chain - row * row * (1 - tangent)) / 4;
    return folded < limits.required_area && straight < limits.required_area;
}

std::optional<Rectangle> check_seam(const ClosedSeam& seam, const std::string& name,
                                    std::size_t asv, const Problem& problem, const Limits& limits,
                                    Claims& claims) {
    const std::size_t n = problem.asv_count();
    if (problem.body_kind() != BodyKind::chain || (asv != (n - 1) / 2 && asv != n / 2)) {
        claims.add(name, false, "it says nothing of an ASV that is not in the middle of a chain");
        return std::nullopt;
    }
    const Passage passage = passage_between(seam.between, problem, limits);
    if (passage.fault) {
        claims.add(name, false, *passage.fault);
        return std::nullopt;
    }
    const Number from = passage.from + limits.shrink, to = passage.to - limits.shrink;
    const Number width = passage.gap + 2 * limits.tolerance, depth = to - from;
    const Rectangle low = passage.cross_section(from), high = passage.cross_section(to);
    check_gap(seam.gap, {low.left, high.right, low.bottom, high.top}, name, claims);
    claims.add_number(name + ", width", seam.width, width);
    claims.add_number(name + ", depth", seam.depth, depth);
    const bool closed = is_impassable(width, depth, problem, limits);
    claims.add(name, closed,
               describe(seam.between) + (closed ? ": no chain gets through" : ": a chain might"));
    if (!closed) return std::nullopt;
    return passage.cross_section((from + to) / 2);
}

}  // namespace asv::core::certificate_check
