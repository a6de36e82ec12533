#include "core/space/proof/motion_checker.hpp"

#include <algorithm>
#include <cmath>

#include "core/space/proof/collision_proof.hpp"
#include "core/space/proof/requirement_proof.hpp"

namespace asv::core {

namespace {

/// A gap of a few coordinates around 1 is right to some 1e-15: what is less is no room at an
/// obstacle, and no violation of the shape. In units of the coordinates' size, their extent.
constexpr double relative_rounding = 1e-14;

/// Among many boxes, how far a moment may prove at most, in mean distances of the boxes.
constexpr double max_spacings = 2;

/// A gap of the line that is shorter than this motion and still open counts as blocked; likewise.
constexpr double relative_finest_motion = 1e-7;

}  // namespace

MotionChecker::MotionChecker(const Chain& chain, const ChainConstraints& constraints,
                             const ObstacleField& field)
    : chain_(chain),
      constraints_(constraints),
      field_(field),
      rounding_(relative_rounding * constraints.extent),
      finest_motion_(relative_finest_motion * constraints.extent),
      motion_(chain) {}

bool MotionChecker::valid(std::span<const double> row) {
    return prove(row, row, 1, true) >= 1;
}

bool MotionChecker::valid(std::span<const double> from, std::span<const double> to) {
    return prove(from, to, 1, true) >= 1;
}

double MotionChecker::valid_prefix(std::span<const double> from, std::span<const double> to,
                                   double resolution) {
    return prove(from, to, resolution, false);
}

double MotionChecker::prove(std::span<const double> from, std::span<const double> to,
                            double resolution, bool only_yes) {
    ++motion_checks_;
    motion_.begin(from, to);
    const ProvenStretch last = prove_around(1, 1, 0);
    bool blocked = last.back < 0;
    double blocked_at = 1;  // the first parameter that is known to be invalid, if there is one
    if (blocked && only_yes) return -1;
    if (last.back >= 1) return 1;
    const ProvenStretch first = prove_around(0, 0, blocked ? 1 : 1 - last.back);
    if (first.ahead < 0) return -1;

    gaps_.clear();
    gaps_.push_back({first.ahead, blocked ? 1 : 1 - last.back});
    while (!gaps_.empty()) {
        const Gap gap = gaps_.back();
        gaps_.pop_back();
        const double length = gap.end - gap.begin;
        if (length <= 0) continue;
        if (length * motion_.speed_bound() <=
            (blocked && gaps_.empty() ? resolution : finest_motion_))
            return gap.begin;
        const double middle = 0.5 * (gap.begin + gap.end);
        const ProvenStretch proven = prove_around(middle, middle - gap.begin, gap.end - middle);
        if (proven.back < 0) {
            if (only_yes) return gap.begin;
            blocked = true;
            blocked_at = middle;
            gaps_.clear();
            gaps_.push_back({gap.begin, middle});
            continue;
        }
        // A stack: the earlier part on top, so that what is left of it is where the line stops. A
        // part that is proven up to the other end leaves no gap, not even one by rounding.
        if (proven.ahead < gap.end - middle) gaps_.push_back({middle + proven.ahead, gap.end});
        if (proven.back < middle - gap.begin) gaps_.push_back({gap.begin, middle - proven.back});
    }
    // Proven right up to a state that is invalid by rounding alone.
    return blocked ? std::nextafter(blocked_at, 0.0) : 1;
}

ProvenStretch MotionChecker::prove_around(double t, double back, double ahead) {
    ++state_checks_;
    constexpr ProvenStretch invalid{-1, -1};
    motion_.move_to(t);
    if (!field_.few()) {
        // Among many boxes, only those near by are looked at, so only near by can be proven.
        const double near =
            max_spacings * field_.spacing() / std::max(motion_.speed_bound(), 1e-300);
        back = std::min(back, near);
        ahead = std::min(ahead, near);
    }
    ProvenStretch stretch{back, ahead};
    if (constraints_.shaped && !prove_turns(motion_, constraints_, rounding_, stretch))
        return invalid;
    if (!prove_bounds(motion_, constraints_, stretch)) return invalid;
    if (constraints_.shaped && chain_.asv_count() >= 3 &&
        (!prove_closing_side(motion_, constraints_, rounding_, stretch) ||
         !prove_area(motion_, constraints_, rounding_, stretch)))
        return invalid;
    return prove_collisions(motion_, field_, rounding_, stretch) ? stretch : invalid;
}

}  // namespace asv::core
