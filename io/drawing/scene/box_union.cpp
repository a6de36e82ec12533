#include "io/drawing/scene/box_union.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "geometry/boxes/box_index.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

/// One side of a box: the line across = at, from low to high along the other axis.
struct Side {
    bool upright = true;   ///< a left or right side
    bool outwards = true;  ///< a right or upper side: the box lies at less than at
    double at = 0;
    double low = 0;
    double high = 0;

    Segment part(double from, double to) const {
        return upright ? Segment{{at, from}, {at, to}} : Segment{{from, at}, {to, at}};
    }

    /// Is the far side of the line in the box, as far as the box reaches along the line?
    bool continued_by(const Box& box) const {
        const double least = upright ? box.low.x : box.low.y;
        const double most = upright ? box.high.x : box.high.y;
        return outwards ? least <= at && at < most : least < at && at <= most;
    }

    /// Has the box this same side, as far as it reaches along the line?
    bool shared_with(const Box& box) const {
        return at ==
               (outwards ? (upright ? box.high.x : box.high.y) : (upright ? box.low.x : box.low.y));
    }
};

class Collector {
  public:
    explicit Collector(std::span<const Box> boxes) : index_(boxes) {}

    UnionSides run() {
        for (std::uint32_t i = 0; i < index_.boxes().size(); ++i) {
            const Box& box = index_.boxes()[i];
            add(i, {true, false, box.low.x, box.low.y, box.high.y});
            add(i, {true, true, box.high.x, box.low.y, box.high.y});
            add(i, {false, false, box.low.y, box.low.x, box.high.x});
            add(i, {false, true, box.high.y, box.low.x, box.high.x});
        }
        return std::move(sides_);
    }

  private:
    void add(std::uint32_t owner, const Side& side) {
        find_covered(owner, side);
        double at = side.low;
        for (const auto& [from, to] : covered_) {
            if (from > at) sides_.outline.push_back(side.part(at, std::min(from, side.high)));
            // Its neighbour has the same seam on its left or lower side.
            if (side.outwards && to > at && from < side.high)
                sides_.seams.push_back(side.part(std::max(from, at), std::min(to, side.high)));
            at = std::max(at, to);
        }
        if (at < side.high) sides_.outline.push_back(side.part(at, side.high));
    }

    /// The stretches of the side that other boxes continue, or that an earlier box has as well, in
    /// order.
    void find_covered(std::uint32_t owner, const Side& side) {
        covered_.clear();
        const Segment line = side.part(side.low, side.high);
        index_.visit(Box{line.a, line.b}, [&](std::uint32_t i) {
            const Box& box = index_.boxes()[i];
            const bool drawn_before = i < owner && side.shared_with(box);
            if (!side.continued_by(box) && !drawn_before) return false;
            const auto [from, to] =
                side.upright ? std::pair{box.low.y, box.high.y} : std::pair{box.low.x, box.high.x};
            covered_.emplace_back(from, to);
            return from <= side.low && side.high <= to;
        });
        std::sort(covered_.begin(), covered_.end());
    }

    geometry::BoxIndex index_;
    std::vector<std::pair<double, double>> covered_;
    UnionSides sides_;
};

}  // namespace

UnionSides union_sides(std::span<const Box> boxes) {
    return Collector(boxes).run();
}

}  // namespace asv::io
