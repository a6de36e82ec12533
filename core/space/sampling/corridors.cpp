#include "core/space/sampling/corridors.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/boxes/box_index.hpp"

namespace asv::core {

using geometry::Box;
using geometry::Point;

Corridors::Corridors(std::span<const Box> boxes, const Box& bounds, double widest) {
    // The sides of the bounds are obstacles too: boxes of no thickness.
    std::vector<Box> walls(boxes.begin(), boxes.end());
    walls.push_back({bounds.low, {bounds.low.x, bounds.high.y}});
    walls.push_back({bounds.low, {bounds.high.x, bounds.low.y}});
    walls.push_back({{bounds.high.x, bounds.low.y}, bounds.high});
    walls.push_back({{bounds.low.x, bounds.high.y}, bounds.high});
    for (const bool vertical : {false, true}) {
        std::vector<Box> view(walls);
        if (vertical) std::transform(view.begin(), view.end(), view.begin(), geometry::transposed);
        const geometry::BoxIndex index(view);
        for (std::size_t i = 0; i < view.size(); ++i) {
            // What lies above box i, over its whole width and up to the widest corridor.
            const Box above{{view[i].low.x, view[i].high.y},
                            {view[i].high.x, view[i].high.y + widest}};
            index.visit(above, [&](std::size_t other) {
                const double low = std::max(view[i].low.x, view[other].low.x);
                const double high = std::min(view[i].high.x, view[other].high.x);
                if (other != i && low < high && view[other].low.y > view[i].high.y) {
                    const Box gap{{low, view[i].high.y}, {high, view[other].low.y}};
                    gaps_.push_back(vertical ? transposed(gap) : gap);
                }
                return false;
            });
        }
    }
}

std::optional<Point> Corridors::sample(Rng& rng) const {
    if (gaps_.empty()) return std::nullopt;
    const Box& gap = gaps_[rng.below(gaps_.size())];
    return Point{rng.uniform(gap.low.x, gap.high.x), rng.uniform(gap.low.y, gap.high.y)};
}

}  // namespace asv::core
