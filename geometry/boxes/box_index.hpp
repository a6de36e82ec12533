#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "geometry/boxes/box_tree.hpp"
#include "geometry/boxes/dust_grid.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "geometry/primitives.hpp"

namespace asv::geometry {

/// A fixed set of boxes that answers which of them a segment may touch and how far the nearest is.
///
/// A hierarchy of nodes eight boxes wide, each node answered by one SIMD comparison; up to 16 boxes
/// are simply scanned. Queries cost O(log m + answers) when the boxes are spread over the plane,
/// allocate nothing and may run in several threads at once. The answers, and their order, are the
/// same on every processor.
class BoxIndex {
  public:
    /// Keeps a copy of the boxes. Empty boxes keep their number but are never found. O(m log m).
    /// Precondition: finite coordinates; fewer than 2^32 boxes.
    explicit BoxIndex(std::span<const Box> boxes)
        : boxes_(boxes.begin(), boxes.end()), tree_(detail::build_box_tree(boxes)) {}

    /// The boxes in the order in which they were given; every index below refers to it.
    std::span<const Box> boxes() const { return boxes_; }

    /// Calls visit(std::uint32_t index) for every box that shares a point with the query box
    /// (touching counts), until one call returns true. Returns whether one did.
    template <class Visit>
    bool visit(const Box& query, Visit&& visit) const {
        return search(begin(query), [&](std::uint32_t index) {
            return overlap(boxes_[index], query) && visit(index);
        });
    }

    /// Calls visit(index) for every box that the closed segment meets (exact, touching counts).
    template <class Visit>
    bool visit(const Segment& query, Visit&& visit) const {
        return search(begin(query, 0), [&](std::uint32_t index) {
            return geometry::meets(query, boxes_[index]) && visit(index);
        });
    }

    /// Calls visit(index) for every box with geometry::distance(query, box) <= radius.
    /// Precondition: radius >= 0.
    template <class Visit>
    bool visit_within(const Segment& query, double radius, Visit&& visit) const {
        return search(begin(query, radius), [&](std::uint32_t index) {
            return geometry::distance(query, boxes_[index]) <= radius && visit(index);
        });
    }

    /// Does the closed segment share a point with any of the boxes? Exact.
    bool meets(const Segment& segment) const {
        return visit(segment, [](std::uint32_t) { return true; });
    }

    /// The least geometry::distance from the segment to a box, or the cut-off where none is less.
    /// The smaller the cut-off, the faster. Precondition: cutoff >= 0, infinity allowed.
    double distance(const Segment& segment, double cutoff) const;

    /// For kernels that search many queries at once.
    const detail::BoxTree& tree() const { return tree_; }
    /// The boxes as far as they are many, small and evenly spread; made when first asked for, as
    /// only those kernels need it. O(m) then.
    const detail::DustGrid& dust() const;
    /// All boxes that are not in dust().
    const detail::BoxTree& beside_dust() const { return dust().empty() ? tree_ : dust().others; }

  private:
    detail::BoxSearch begin(const Box& query) const;
    detail::BoxSearch begin(const Segment& query, double radius) const;
    /// Opens nodes until one of them yields boxes or none is left; returns how many are in found.
    std::uint32_t advance(detail::BoxSearch& search) const;

    template <class Accept>
    bool search(detail::BoxSearch search, Accept&& accept) const {
        while (search.open_count > 0) {
            const std::uint32_t count = advance(search);
            for (std::uint32_t i = 0; i < count; ++i) {
                if (accept(search.found[i])) return true;
            }
        }
        return false;
    }

    std::vector<Box> boxes_;
    detail::BoxTree tree_;

    struct Dust {
        std::once_flag made;
        detail::DustGrid grid;
    };
    std::unique_ptr<Dust> dust_ = std::make_unique<Dust>();
};

}  // namespace asv::geometry
