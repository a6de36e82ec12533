#include "geometry/boxes/box_index.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/forced_target.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;
using test::ForcedTarget;
using Indices = std::vector<std::uint32_t>;

template <class Meets>
Indices brute_force(std::span<const Box> boxes, Meets&& meets) {
    Indices found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (!is_empty(boxes[i]) && meets(boxes[i])) found.push_back(i);
    }
    return found;
}

/// What a visit finds, sorted; every box at most once.
template <class Visit>
Indices found_by(Visit&& visit) {
    Indices found;
    visit([&](std::uint32_t index) {
        found.push_back(index);
        return false;
    });
    std::ranges::sort(found);
    EXPECT_EQ(std::ranges::adjacent_find(found), found.end()) << "a box was visited twice";
    return found;
}

double brute_force_distance(std::span<const Box> boxes, const Segment& segment, double cutoff) {
    for (const Box& box : boxes) {
        if (!is_empty(box)) cutoff = std::min(cutoff, distance(segment, box));
    }
    return cutoff;
}

/// Small squares, long walls and degenerate boxes, some of them empty, on a fine lattice or not, in
/// a world of the given size.
std::vector<Box> random_boxes(Adversary& draw, int count, double size) {
    std::vector<Box> boxes;
    const bool lattice = draw.pick(2) == 0;
    const auto coordinate = [&] {
        return size * (lattice ? draw.pick(65) / 64.0 : draw.uniform(0, 1));
    };
    for (int i = 0; i < count; ++i) {
        const Point low{coordinate(), coordinate()};
        const double wide = draw.pick(10) == 0 ? 0.5 : 1 / 64.0;
        const double high = draw.pick(10) == 0 ? 0.5 : 1 / 64.0;
        boxes.push_back(
            {low, {low.x + size * wide * draw.pick(3), low.y + size * high * draw.pick(3)}});
        if (draw.pick(20) == 0) std::swap(boxes.back().low, boxes.back().high);
    }
    return boxes;
}

void expect_same_as_brute_force(const BoxIndex& index, Adversary& draw, double size) {
    const auto boxes = index.boxes();
    const auto coordinate = [&] {
        return size * (draw.pick(2) == 0 ? draw.pick(65) / 64.0 : draw.uniform(-0.2, 1.2));
    };
    const Point a{coordinate(), coordinate()};
    const Point b{coordinate(), draw.pick(4) == 0 ? a.y : coordinate()};
    const double t = draw.pick(3) == 0 ? 1 : 0.1;
    const Segment segment{a, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}};
    const Box region = bounds(segment);
    const double radius = size * (draw.pick(3) == 0 ? 1 / 64.0 : draw.uniform(0, 0.1));

    EXPECT_EQ(found_by([&](auto f) { index.visit(region, f); }),
              brute_force(boxes, [&](const Box& box) { return overlap(box, region); }));
    const Indices met = brute_force(boxes, [&](const Box& box) { return meets(segment, box); });
    EXPECT_EQ(found_by([&](auto f) { index.visit(segment, f); }), met);
    EXPECT_EQ(index.meets(segment), !met.empty());
    EXPECT_EQ(found_by([&](auto f) { index.visit_within(segment, radius, f); }),
              brute_force(boxes, [&](const Box& box) { return distance(segment, box) <= radius; }));
    for (const double cutoff : {0.0, radius, infinity}) {
        EXPECT_EQ(index.distance(segment, cutoff), brute_force_distance(boxes, segment, cutoff));
    }
}

TEST(BoxIndex, SameAsBruteForce) {
    for (const std::string& target : geometry::simd::instruction_sets()) {
        const ForcedTarget forced(target);
        constexpr std::uint64_t seed = 31;
        Adversary draw(seed);
        for (const int count : {0, 1, 2, 7, 8, 9, 31, 32, 33, 64, 65, 100, 257, 600, 2500}) {
            for (const double size : {1.0, 1e-30, 1e6, 1e40, 1e-45, 1e300}) {
                const BoxIndex index(random_boxes(draw, count, size));
                for (int i = 0; i < 20; ++i) {
                    SCOPED_TRACE(::testing::Message()
                                 << "seed " << seed << ", target " << target << ", boxes " << count
                                 << ", size " << size << ", query " << i);
                    expect_same_as_brute_force(index, draw, size);
                    if (HasFailure()) return;
                }
            }
        }
    }
}

// From some number of boxes on they are kept in steps of their leaf.
TEST(BoxIndex, ManyBoxesAsByBruteForce) {
    for (const std::string& target : geometry::simd::instruction_sets()) {
        const ForcedTarget forced(target);
        constexpr std::uint64_t seed = 32;
        Adversary draw(seed);
        for (const double size : {1.0, 1e-30, 1e6, 1e40, 1e-45, 1e300}) {
            const int count = 32'760 + draw.pick(2000) + draw.pick(2) * 5000;
            const BoxIndex index(random_boxes(draw, count, size));
            for (int i = 0; i < 5; ++i) {
                SCOPED_TRACE(::testing::Message() << "seed " << seed << ", target " << target
                                                  << ", size " << size << ", query " << i);
                expect_same_as_brute_force(index, draw, size);
                if (HasFailure()) return;
            }
        }
    }
}

TEST(BoxIndex, VisitStopsWhenTold) {
    const std::vector<Box> boxes(100, Box{{0, 0}, {1, 1}});
    const BoxIndex index(boxes);
    int calls = 0;
    EXPECT_TRUE(index.visit(Box{{0, 0}, {1, 1}}, [&](std::uint32_t) { return ++calls == 3; }));
    EXPECT_EQ(calls, 3);
}

TEST(BoxIndex, KeepsTheBoxesInOrder) {
    const std::vector<Box> boxes{{{2, 2}, {3, 3}}, {{1, 0}, {0, 1}}, {{0, 0}, {1, 1}}};
    const BoxIndex index(boxes);
    EXPECT_TRUE(std::ranges::equal(index.boxes(), boxes));
    EXPECT_EQ(found_by([&](auto f) { index.visit(Box{{-9, -9}, {9, 9}}, f); }), (Indices{0, 2}));
}

}  // namespace
}  // namespace asv::geometry
