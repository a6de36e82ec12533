#include "tests/kit/batch/line_check.hpp"

#include <algorithm>
#include <cassert>

namespace asv::test {

using geometry::simd::all_lanes;
using geometry::simd::lanes;

bool LineCheck::valid(std::span<const double> from, std::span<const double> step,
                      double resolution) {
    core::batch::Stretches line{from, step, {}, {}};
    return prove(line, resolution, true) >= 1;
}

double LineCheck::valid_prefix(std::span<const double> from, std::span<const double> step,
                               double resolution) {
    core::batch::Stretches line{from, step, {}, {}};
    return prove(line, resolution, false);
}

// Everything before the first open stretch is proven. What lies behind a blocked place does not
// matter any more.
double LineCheck::prove(core::batch::Stretches& line, double resolution, bool whole) {
    assert(resolution > 0);
    double end = 1;
    open_.clear();
    cut({0, 1}, lanes);
    while (!open_.empty()) {
        take(line);
        const auto [certified, midpoint_valid] = batch_.certify(line);
        if (whole && midpoint_valid != all_lanes) return 0;
        std::size_t rest = 0;  // what this round leaves open, at the front of taken_
        for (std::size_t lane = 0; lane < taken_.size(); ++lane) {
            if ((certified >> lane & 1) != 0) continue;
            const Stretch stretch = taken_[lane];
            const bool blocked = (midpoint_valid >> lane & 1) == 0;
            const bool hopeless = stretch.end - stretch.begin <= resolution;
            if (hopeless && whole) return 0;
            if (!hopeless)
                taken_[rest++] = {stretch.begin, blocked ? line.middle[lane] : stretch.end};
            if (!hopeless && !blocked) continue;
            end = hopeless ? stretch.begin : line.middle[lane];
            open_.clear();
            break;
        }
        // With few stretches open, each is cut into many, so that no lane idles.
        const std::size_t pieces =
            lanes / std::clamp<std::size_t>(open_.size() + rest, 1, lanes / 2);
        while (rest > 0) cut(taken_[--rest], pieces);
    }
    return end;
}

void LineCheck::cut(const Stretch& stretch, std::size_t pieces) {
    const double length = (stretch.end - stretch.begin) / static_cast<double>(pieces);
    double end = stretch.end;
    for (std::size_t i = pieces; i-- > 0;) {
        const double begin =
            i == 0 ? stretch.begin : stretch.begin + static_cast<double>(i) * length;
        open_.push_back({begin, end});
        end = begin;
    }
}

void LineCheck::take(core::batch::Stretches& line) {
    const std::size_t count = std::min(open_.size(), lanes);
    taken_.assign(open_.rbegin(), open_.rbegin() + static_cast<std::ptrdiff_t>(count));
    open_.resize(open_.size() - count);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        // Idle lanes repeat the last stretch.
        const Stretch& stretch = taken_[std::min(lane, count - 1)];
        line.middle[lane] = 0.5 * (stretch.begin + stretch.end);
        // The rounding of these two must not open a crack between neighbours.
        line.half_length[lane] = 0.5 * (stretch.end - stretch.begin) + 0x1p-50;
    }
}

}  // namespace asv::test
