// One query against the eight boxes of a node; compiled once for every instruction set.
#if defined(ASV_GEOMETRY_BOX_QUERY_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASV_GEOMETRY_BOX_QUERY_INL_HPP
#undef ASV_GEOMETRY_BOX_QUERY_INL_HPP
#else
#define ASV_GEOMETRY_BOX_QUERY_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "asv/geometry/box_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace asv::geometry::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Eight floats, in as many vectors as the instruction set needs.
using Float8 = hn::CappedTag<float, WideNode::width>;
using Floats = hn::Vec<Float8>;

HWY_INLINE Floats load_side(const WideNode& node, std::uint32_t side, std::size_t i) {
    return hn::Load(Float8(), node.side[side].data() + i);
}

/// The ends of the boxes' shadows on the query's normal: far >= near.
struct Shadow {
    Floats near, far;
};

HWY_INLINE Shadow shadow(const WideNode& node, std::size_t i, const BoxQuery& query) {
    const Float8 d;
    // Chosen by arithmetic, as the signs of the normals are as good as random.
    const std::uint32_t right = query.normal_x >= 0 ? 2 : 0;
    const std::uint32_t up = query.normal_y >= 0 ? 2 : 0;
    const auto x = hn::Set(d, query.normal_x);
    const auto y = hn::Set(d, query.normal_y);
    const auto far_y = load_side(node, WideNode::low_y + up, i);
    const auto near_y = load_side(node, WideNode::high_y - up, i);
    return {hn::MulAdd(x, load_side(node, WideNode::high_x - right, i), hn::Mul(y, near_y)),
            hn::MulAdd(x, load_side(node, WideNode::low_x + right, i), hn::Mul(y, far_y))};
}

template <class D>
HWY_INLINE std::uint32_t to_bits(D d, hn::Mask<D> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
}

/// Bit l: the box in lane l may have what the query asks for.
HWY_INLINE std::uint32_t candidates(const WideNode& node, const BoxQuery& query) {
    const Float8 d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
        const auto in_x =
            hn::And(hn::Le(load_side(node, WideNode::low_x, i), hn::Set(d, query.high_x)),
                    hn::Ge(load_side(node, WideNode::high_x, i), hn::Set(d, query.low_x)));
        const auto in_y =
            hn::And(hn::Le(load_side(node, WideNode::low_y, i), hn::Set(d, query.high_y)),
                    hn::Ge(load_side(node, WideNode::high_y, i), hn::Set(d, query.low_y)));
        const auto [near, far] = shadow(node, i, query);
        // Overflow leaves NaN, which must not count as apart.
        const auto apart = hn::Or(hn::Gt(near, hn::Set(d, query.normal_high)),
                                  hn::Lt(far, hn::Set(d, query.normal_low)));
        bits |= to_bits(d, hn::AndNot(apart, hn::And(in_x, in_y))) << i;
    }
    return bits;
}

/// Nodes that are still to be opened on one level, each for one query.
struct OpenLevel {
    static constexpr std::uint32_t batch = 16;
    std::uint32_t count = 0;
    // A batch opens at most batch * width children; the last store may write a whole width.
    std::array<std::uint32_t, (batch + 1) * WideNode::width> node, query;

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
};

/// Goes down the tree with several queries together, so that the processor can work on many nodes
/// at once instead of waiting for one after the other. Calls visit(node, lane in it, query, index
/// of the box) for every box that a query may reach; a query for which done(query) holds is given
/// up.
template <class Done, class Visit>
class JointSearch {
  public:
    HWY_INLINE JointSearch(const BoxTree& tree, std::span<const BoxQuery> queries, Done done,
                           Visit visit)
        : tree_(tree), queries_(queries), done_(done), visit_(visit) {}

    HWY_INLINE void run() {
        constexpr std::size_t at_once = OpenLevel::batch * WideNode::width / BoxTree::most_roots;
        for (std::size_t i = 0; i < queries_.size(); i += at_once) {
            run(i, std::min(i + at_once, queries_.size()));
        }
    }

  private:
    HWY_INLINE void run(std::size_t begin, std::size_t end) {
        const std::uint32_t top = tree_.search_level();
        const std::uint32_t roots = (1U << tree_.node_count(top)) - 1;
        for (std::size_t q = begin; q < end; ++q) {
            open_[top].push(0, roots, static_cast<std::uint32_t>(q));
        }
        for (std::uint32_t level = top; level <= top;) {
            if (open_[level].count == 0) {
                ++level;
            } else if (level == 0) {
                open_leaves();
            } else {
                open_batch(level);
                --level;
            }
        }
    }

    /// Replaces some nodes of a level by their children on the level below, which is empty before.
    HWY_INLINE void open_batch(std::uint32_t level) {
        OpenLevel& here = open_[level];
        OpenLevel& below = open_[level - 1];
        const std::uint32_t end = here.count;
        here.count -= std::min(end, OpenLevel::batch);
        for (std::uint32_t i = here.count; i < end; ++i) {
            const std::uint32_t node = here.node[i], query = here.query[i];
            if (done_(query)) continue;
            const std::uint32_t bits = candidates(tree_.node({level, node}), queries_[query]);
            below.push(node * WideNode::width, bits, query);
        }
        for (std::uint32_t i = 0; i < below.count; ++i) {
            const WideNode& node = tree_.node({level - 1, below.node[i]});
            hwy::Prefetch(node.side[WideNode::low_x].data());
            hwy::Prefetch(node.side[WideNode::high_x].data());
        }
    }

    HWY_INLINE void open_leaves() {
        OpenLevel& here = open_[0];
        for (std::uint32_t i = 0; i < here.count; ++i) {
            const std::uint32_t query = here.query[i], first = here.node[i] * WideNode::width;
            if (done_(query)) continue;
            const WideNode& node = tree_.node({0, here.node[i]});
            for (std::uint32_t bits = candidates(node, queries_[query]); bits != 0;
                 bits &= bits - 1) {
                const auto lane = static_cast<std::uint32_t>(__builtin_ctz(bits));
                visit_(node, lane, query, tree_.order[first + lane]);
            }
        }
        here.count = 0;
    }

    const BoxTree& tree_;
    std::span<const BoxQuery> queries_;
    Done done_;
    Visit visit_;
    std::array<OpenLevel, BoxTree::most_levels> open_;
};

template <class Done, class Visit>
HWY_INLINE void for_each_candidate(const BoxTree& tree, std::span<const BoxQuery> queries,
                                   Done done, Visit visit) {
    JointSearch<Done, Visit>(tree, queries, done, visit).run();
}

}  // namespace asv::geometry::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
