#include "asv/geometry/batch/segment_box_batch.hpp"

#include <algorithm>
#include <vector>

#include "adversarial.hpp"
#include "each_target.hpp"
#include "exact_oracle.hpp"
#include <gtest/gtest.h>

namespace asv::geometry {
namespace {

/// Pairs coordinate by coordinate, with the oracle's answers.
struct Pairs {
    std::vector<double> ax, ay, bx, by, low_x, low_y, high_x, high_y;
    std::vector<std::uint8_t> expected;

    void push_back(const Segment& segment, const Box& box) {
        ax.push_back(segment.a.x);
        ay.push_back(segment.a.y);
        bx.push_back(segment.b.x);
        by.push_back(segment.b.y);
        low_x.push_back(box.low.x);
        low_y.push_back(box.low.y);
        high_x.push_back(box.high.x);
        high_y.push_back(box.high.y);
        expected.push_back(!is_empty(box) && oracle::meets(segment, box));
    }
    void clear() {
        for (auto* row : {&ax, &ay, &bx, &by, &low_x, &low_y, &high_x, &high_y}) row->clear();
        expected.clear();
    }
    batch::Segments segments() const { return {ax, ay, bx, by}; }
    batch::Boxes boxes() const { return {low_x, low_y, high_x, high_y}; }
};

/// A segment and a box as they come in planning: about as large as the box, somewhere near it.
void push_random(Pairs& pairs, Adversary& draw) {
    const Point a{draw.uniform(-0.05, 0.15), draw.uniform(-0.05, 0.15)};
    const Point b{a.x + draw.uniform(-0.05, 0.05), a.y + draw.uniform(-0.05, 0.05)};
    pairs.push_back({a, b}, {{0, 0}, {draw.uniform(0, 0.1), draw.uniform(0, 0.1)}});
}

TEST(SegmentBoxBatch, AgreesWithExactKernelOnEveryTarget) {
    constexpr std::uint64_t seed = 101;
    constexpr std::size_t chunk = 100'003;  // not a multiple of any lane count
    const std::size_t count = test_count(10'000'000);
    const std::vector<std::int64_t> targets = simd_targets();
    Adversary draw(seed);
    Pairs pairs;
    std::vector<std::uint8_t> answers;
    for (std::size_t done = 0; done < count; done += answers.size()) {
        pairs.clear();
        while (pairs.expected.size() < std::min(chunk, count - done)) {
            const auto [segment, box] = draw.pair();
            pairs.push_back(segment, box);
            push_random(pairs, draw);
        }
        for (const std::int64_t target : targets) {
            const ForcedTarget forced(target);
            answers.assign(pairs.expected.size(), 2);
            batch::meets(pairs.segments(), pairs.boxes(), answers);
            const auto [wrong, expected] = std::ranges::mismatch(answers, pairs.expected);
            ASSERT_EQ(wrong, answers.end())
                << "seed " << seed << ", target " << hwy::TargetName(target) << ", pair "
                << done + static_cast<std::size_t>(wrong - answers.begin());
        }
    }
}

TEST(SegmentBoxBatch, EmptyBoxesMeetNothing) {
    for (const std::int64_t target : simd_targets()) {
        const ForcedTarget forced(target);
        Pairs pairs;
        for (int i = 0; i < 16; ++i) pairs.push_back({{-1, 0.5}, {2, 0.5}}, {{0.6, 0}, {0.4, 1}});
        std::vector<std::uint8_t> answers(16, 2);
        batch::meets(pairs.segments(), pairs.boxes(), answers);
        EXPECT_EQ(std::ranges::count(answers, 0), 16);
    }
}

}  // namespace
}  // namespace asv::geometry
