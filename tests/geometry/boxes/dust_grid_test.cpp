#include "geometry/boxes/dust_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/batch/chain_batch.hpp"
#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/forced_target.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using core::batch::ChainBatch;
using core::batch::ChainLimits;
using detail::build_dust_grid;
using detail::DustGrid;
using detail::DustLine;
using geometry::simd::LaneMask;
using geometry::simd::lanes;
using geometry::simd::Pack;
using test::Adversary;
using test::ForcedTarget;

constexpr std::size_t many = 40'000;

/// Specks evenly spread over the unit square, or over one of that size far from the origin.
std::vector<Box> specks(Adversary& draw, const Point& low = {0, 0}) {
    std::vector<Box> boxes;
    while (boxes.size() < many) {
        const Point corner{low.x + draw.uniform(0, 1), low.y + draw.uniform(0, 1)};
        const double size = draw.pick(4) == 0 ? 0 : draw.uniform(0, 1e-5);
        boxes.push_back({corner, {corner.x + size, corner.y + draw.uniform(0, 1e-5)}});
    }
    return boxes;
}

/// Boxes nearly as large as the grid takes them.
std::vector<Box> pebbles(Adversary& draw) {
    std::vector<Box> boxes;
    while (boxes.size() < many) {
        const Point low{draw.uniform(0, 1), draw.uniform(0, 1)};
        boxes.push_back({low, {low.x + draw.uniform(0, 0.0025), low.y + draw.uniform(0, 0.0025)}});
    }
    return boxes;
}

/// Points on a lattice of 200 x 200, some one ulp off.
std::vector<Box> lattice(Adversary& draw) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < many; ++i) {
        const Point node{static_cast<double>(i % 200) / 199, static_cast<double>(i / 200) / 199};
        const Point point = draw.nudged(node);
        boxes.push_back({point, point});
    }
    return boxes;
}

/// Specks, a heap of them in one place, long walls and boxes that are empty.
std::vector<Box> mixed(Adversary& draw) {
    std::vector<Box> boxes = specks(draw);
    for (int i = 0; i < 300; ++i) {
        const Point corner{0.3 + draw.uniform(0, 1e-4), 0.7 + draw.uniform(0, 1e-4)};
        boxes.push_back({corner, corner});
        const double length = draw.uniform(0, 0.1), thickness = draw.uniform(0, 0.001);
        const Point wall{draw.uniform(-0.1, 1), draw.uniform(-0.1, 1)};
        boxes.push_back({wall, {wall.x + length, wall.y + thickness}});
        boxes.push_back({wall, {wall.x - 1, wall.y - 1}});
    }
    return boxes;
}

TEST(DustGrid, HoldsEachSmallBoxInItsCellAndTheOthersInATree) {
    Adversary draw(1);
    const std::vector<Box> boxes = mixed(draw);
    const DustGrid grid = build_dust_grid(boxes);
    ASSERT_FALSE(grid.empty());
    const std::size_t cells = std::size_t{grid.columns} * grid.rows;
    EXPECT_GT(grid.lines.size(), cells) << "the heap needs further lines";
    EXPECT_EQ(grid.boxes.size() + grid.others.order.size() + 300, boxes.size());
    EXPECT_GT(grid.others.order.size(), 200U);
    std::size_t held = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        std::size_t line = cell;
        for (bool more = true; more;) {
            for (std::uint32_t i = grid.first[line]; i < grid.first[line + 1]; ++i, ++held) {
                const std::uint32_t lane = i - grid.first[line];
                const auto centre = [&](double low, double high, double grid_low, std::size_t at) {
                    return ((low + high) / 2 - grid_low) / grid.cell - static_cast<double>(at);
                };
                const Box& box = grid.boxes[i];
                const double half_step = 0.5 / DustLine::steps + 1e-9;
                EXPECT_NEAR(centre(box.low.x, box.high.x, grid.low.x, cell % grid.columns),
                            grid.lines[line].x[lane] / DustLine::steps, half_step);
                EXPECT_NEAR(centre(box.low.y, box.high.y, grid.low.y, cell / grid.columns),
                            grid.lines[line].y[lane] / DustLine::steps, half_step);
                EXPECT_LE(box.high.x - box.low.x, 2 * grid.half_x);
                EXPECT_LE(box.high.y - box.low.y, 2 * grid.half_y);
            }
            more = grid.lines[line].goes_on();
            EXPECT_EQ(grid.further[line] != 0, more);
            line = grid.further[line];
        }
    }
    EXPECT_EQ(held, grid.boxes.size());
}

TEST(DustGrid, LeavesToTheTreeWhatIsNoDust) {
    Adversary draw(2);
    test::Random random(2);
    EXPECT_TRUE(build_dust_grid({}).empty());
    EXPECT_TRUE(build_dust_grid(test::dust(1000, random)).empty()) << "few boxes";
    EXPECT_TRUE(build_dust_grid(test::grid_map(many, random)).empty()) << "crowded";
    std::vector<Box> boxes = specks(draw);
    for (Box& box : boxes) box.high = {box.low.x + 0.02, box.high.y};
    EXPECT_TRUE(build_dust_grid(boxes).empty()) << "long boxes";
    boxes = specks(draw);
    for (Box& box : boxes) box.low.y = box.high.y = 0;
    EXPECT_TRUE(build_dust_grid(boxes).empty()) << "all on one line";
    boxes.assign(many, {{0.5, 0.5}, {0.5, 0.5}});
    EXPECT_TRUE(build_dust_grid(boxes).empty()) << "all in one place";
    for (const double size : {1e-300, 1e155, 1e300}) {
        boxes = specks(draw);
        for (Box& box : boxes) box = {{size * box.low.x, size * box.low.y}, {size, size}};
        EXPECT_TRUE(build_dust_grid(boxes).empty()) << "size " << size;
    }
    for (const double offset : {1e12, 1e300}) {
        boxes = specks(draw, {offset, 0});
        EXPECT_TRUE(build_dust_grid(boxes).empty()) << "offset " << offset;
    }
}

/// One broom without limits to its shape. The bounds are hardly wider than it needs among boxes of
/// a unit square: the slack of links grows with them, and would hide errors of the search.
ChainLimits single_broom(double length, const Point& low) {
    const double around = length + 0.2;
    ChainLimits limits;
    limits.link = length;
    limits.bounds = {{low.x - around, low.y - around}, {low.x + 1 + around, low.y + 1 + around}};
    limits.min_area = limits.min_closing_side = -1;
    limits.min_first_closing_turn = limits.min_last_closing_turn = -1;
    return limits;
}

/// Where a broom is: anywhere, along an axis or a diagonal, or touching a box within an ulp.
std::vector<Pack> brooms(const std::vector<Box>& boxes, const Point& low, double length,
                         Adversary& draw) {
    std::vector<Pack> rows(3);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        double heading = draw.uniform(-std::numbers::pi, std::numbers::pi);
        if (draw.pick(3) == 0) heading = std::numbers::pi / 4 * (draw.pick(9) - 4);
        Point start{low.x + draw.uniform(-0.1, 1.1), low.y + draw.uniform(-0.1, 1.1)};
        if (draw.pick(2) == 0) {
            const Box& box = boxes[static_cast<std::size_t>(draw.pick(many))];
            const Point corner = draw.nudged(draw.pick(2) == 0 ? box.low : box.high);
            const double before = draw.uniform(0, length);
            start = {corner.x - before * std::cos(heading), corner.y - before * std::sin(heading)};
        }
        rows[0][lane] = start.x, rows[1][lane] = start.y, rows[2][lane] = heading;
    }
    return rows;
}

void expect_same_as_index(const std::vector<Box>& boxes, const Point& low, Adversary& draw) {
    const BoxIndex index(boxes);
    ASSERT_FALSE(index.dust().empty());
    std::size_t valid_count = 0, count = 0;
    for (const double length : {0.0, 0.001, 0.02, 0.3, 3.0}) {
        const ChainLimits limits = single_broom(length, low);
        ChainBatch batch(1, limits, index);
        for (std::size_t i = 0; i < test::scaled(300); ++i) {
            const std::vector<Pack> rows = brooms(boxes, low, length, draw);
            for (const std::string& target : geometry::simd::instruction_sets()) {
                const ForcedTarget forced(target);
                const LaneMask valid = batch.valid(rows);
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const Segment broom{{batch.x()[0][lane], batch.y()[0][lane]},
                                        {batch.x()[1][lane], batch.y()[1][lane]}};
                    ASSERT_EQ(valid >> lane & 1, index.meets(broom) ? 0U : 1U)
                        << target << ", length " << length << ", broom " << i << ", lane " << lane;
                    valid_count += valid >> lane & 1;
                    ++count;
                }
            }
        }
    }
    EXPECT_GT(valid_count, count / 10);
    EXPECT_LT(valid_count, count - count / 20);
}

TEST(DustGrid, BroomsMeetTheSameBoxesAsInTheTree) {
    Adversary draw(3);
    {
        SCOPED_TRACE("specks");
        expect_same_as_index(specks(draw), {0, 0}, draw);
    }
    {
        SCOPED_TRACE("pebbles");
        expect_same_as_index(pebbles(draw), {0, 0}, draw);
    }
    {
        SCOPED_TRACE("lattice");
        expect_same_as_index(lattice(draw), {0, 0}, draw);
    }
    {
        SCOPED_TRACE("mixed");
        expect_same_as_index(mixed(draw), {0, 0}, draw);
    }
    {
        SCOPED_TRACE("far from the origin");
        expect_same_as_index(specks(draw, {-3000, 5000}), {-3000, 5000}, draw);
    }
}

TEST(DustGrid, NoStretchIsCertifiedThroughABox) {
    Adversary draw(4);
    const BoxIndex index(mixed(draw));
    std::size_t certified_count = 0;
    for (const double motion : {1e-4, 1e-2, 1.0}) {
        const ChainLimits limits = single_broom(0.02, {0, 0});
        ChainBatch batch(1, limits, index);
        for (std::size_t i = 0; i < test::scaled(300); ++i) {
            std::vector<double> from{draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(-3, 3)};
            std::vector<double> step;
            for (int k = 0; k < 3; ++k) step.push_back(draw.uniform(-motion, motion));
            core::batch::Stretches stretches{from, step, {}, {}};
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                stretches.middle[lane] = (2.0 * static_cast<double>(lane) + 1) / 16;
                stretches.half_length[lane] = 1 / 16.0;
            }
            const LaneMask certified = batch.certify(stretches).certified;
            for (const std::string& target : geometry::simd::instruction_sets()) {
                const ForcedTarget forced(target);
                ASSERT_EQ(batch.certify(stretches).certified, certified);
            }
            certified_count += static_cast<std::size_t>(std::popcount(certified));
            for (int j = -100; j <= 100; ++j) {
                std::vector<Pack> rows(3);
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const double t = stretches.middle[lane] + j / 1600.0;
                    for (std::size_t k = 0; k < 3; ++k) rows[k][lane] = from[k] + t * step[k];
                }
                ASSERT_EQ(certified & ~batch.valid(rows), 0U) << "motion " << i;
            }
        }
    }
    EXPECT_GT(certified_count, 3 * lanes * test::scaled(300) / 4);
}

}  // namespace
}  // namespace asv::geometry
