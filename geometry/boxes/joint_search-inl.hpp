// Several queries down the tree together; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BOXES_JOINT_SEARCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BOXES_JOINT_SEARCH_INL_HPP
#undef ASV_GEOMETRY_BOXES_JOINT_SEARCH_INL_HPP
#else
#define ASV_GEOMETRY_BOXES_JOINT_SEARCH_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "geometry/boxes/box_query-inl.hpp"
#include "geometry/boxes/box_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::detail::HWY_NAMESPACE {

/// Nodes or leaves that are still to be opened, each for one query.
template <std::uint32_t most>
struct OpenNodes {
    std::uint32_t count = 0;
    // The last store may write a whole width beyond the count.
    std::array<std::uint32_t, most + WideNode::width> node, query;

    /// Appends node first + l for every bit l, without a branch that depends on the bits.
    HWY_INLINE void push(std::uint32_t first, std::uint32_t bits, std::uint32_t of_query) {
        const hn::CappedTag<std::uint32_t, WideNode::width> d;
        const hn::Rebind<std::uint8_t, decltype(d)> narrow;
        for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
            const auto lanes = hn::PromoteTo(d, hn::LoadU(narrow, &set_bits[bits][i]));
            hn::StoreU(hn::Add(hn::Set(d, first), lanes), d, &node[count + i]);
            hn::StoreU(hn::Set(d, of_query), d, &query[count + i]);
        }
        count += static_cast<std::uint32_t>(hwy::PopCount(bits));
    }

    HWY_INLINE void drop_first(std::uint32_t dropped) {
        std::copy(node.begin() + dropped, node.begin() + count, node.begin());
        std::copy(query.begin() + dropped, query.begin() + count, query.begin());
        count -= dropped;
    }
};

/// Goes down the tree with several queries together, so that the processor can work on many nodes
/// at once instead of waiting for one after the other: whatever is opened or looked at was asked
/// for some work earlier. Calls visit(i, query) for every tree.boxes[i] that a query may reach and,
/// where there are leaves, for some a step farther; a query for which done(query) holds is given
/// up.
template <class Done, class Visit>
class JointSearch {
  public:
    HWY_INLINE JointSearch(const BoxTree& tree, std::span<const BoxQuery> queries, Done done,
                           Visit visit)
        : tree_(tree), queries_(queries), done_(done), visit_(visit) {}

    HWY_INLINE void run() {
        constexpr std::size_t at_once = max_children / BoxTree::max_roots;
        for (std::size_t i = 0; i < queries_.size(); i += at_once) {
            run(i, std::min(i + at_once, queries_.size()));
        }
        open_leaves(leaves_.count);
        look_at_found();
    }

  private:
    static constexpr std::uint32_t batch = 16;
    static constexpr std::uint32_t max_children = batch * WideNode::width;
    static constexpr std::uint32_t enough_found = 16;

    HWY_INLINE void run(std::size_t begin, std::size_t end) {
        const std::uint32_t top = tree_.search_level();
        const std::uint32_t roots = (1U << tree_.node_count(top)) - 1;
        for (std::size_t q = begin; q < end; ++q) {
            open_[top].push(0, roots, static_cast<std::uint32_t>(q));
        }
        for (std::uint32_t level = top; level <= top;) {
            if (open_[level].count == 0) {
                ++level;
            } else if (level > 1) {
                open_batch(level, open_[level - 1]);
                --level;
            } else if (tree_.leaves.empty()) {
                open_lowest();
            } else {
                const std::uint32_t waiting = leaves_.count;
                open_batch(level, leaves_);
                open_leaves(waiting);
            }
        }
    }

    /// Replaces some nodes of a level by their children on the level below.
    template <class Below>
    HWY_INLINE void open_batch(std::uint32_t level, Below& below) {
        auto& here = open_[level];
        const std::uint32_t end = here.count, had = below.count;
        here.count -= std::min(end, batch);
        for (std::uint32_t i = here.count; i < end; ++i) {
            const std::uint32_t node = here.node[i], query = here.query[i];
            if (done_(query)) continue;
            const std::uint32_t bits = candidates(tree_.node({level, node}), queries_[query]);
            below.push(node * WideNode::width, bits, query);
        }
        for (std::uint32_t i = had; i < below.count; ++i) prefetch({level - 1, below.node[i]});
    }

    HWY_INLINE void prefetch(NodeId id) const {
        if (id.level == 0) {
            hwy::Prefetch(&tree_.leaves[id.index]);
            return;
        }
        const WideNode& node = tree_.node(id);
        hwy::Prefetch(node.side[low_x].data());
        hwy::Prefetch(node.side[high_x].data());
    }

    HWY_INLINE void open_leaves(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t query = leaves_.query[i], leaf = leaves_.node[i];
            if (done_(query)) continue;
            const LeafFrame frame = tree_.frame(leaf);
            keep(leaf * Leaf::width, candidates({tree_.leaves[leaf], frame}, queries_[query]),
                 query);
        }
        leaves_.drop_first(count);
    }

    /// Opens the nodes whose lanes are boxes.
    HWY_INLINE void open_lowest() {
        auto& here = open_[1];
        for (std::uint32_t i = 0; i < here.count; ++i) {
            const std::uint32_t query = here.query[i], node = here.node[i];
            if (done_(query)) continue;
            keep(node * WideNode::width, candidates(tree_.node({1, node}), queries_[query]), query);
        }
        here.count = 0;
    }

    /// Boxes that leaves or nodes let through wait until they are in the cache.
    HWY_INLINE void keep(std::uint32_t first, std::uint32_t bits, std::uint32_t query) {
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t box = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
            hwy::Prefetch(&tree_.boxes[box]);
            found_[found_count_++] = {box, query};
        }
        if (found_count_ >= enough_found) look_at_found();
    }

    HWY_INLINE void look_at_found() {
        for (std::uint32_t i = 0; i < found_count_; ++i) {
            const auto [box, query] = found_[i];
            if (!done_(query)) visit_(box, query);
        }
        found_count_ = 0;
    }

    struct Found {
        std::uint32_t box, query;
    };

    const BoxTree& tree_;
    std::span<const BoxQuery> queries_;
    Done done_;
    Visit visit_;
    std::array<OpenNodes<max_children>, BoxTree::max_levels> open_;  ///< level 0 stays empty
    OpenNodes<2 * max_children> leaves_;
    std::uint32_t found_count_ = 0;
    std::array<Found, enough_found + Leaf::width> found_;
};

template <class Done, class Visit>
HWY_INLINE void for_each_candidate(const BoxTree& tree, std::span<const BoxQuery> queries,
                                   Done done, Visit visit) {
    JointSearch<Done, Visit>(tree, queries, done, visit).run();
}

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
