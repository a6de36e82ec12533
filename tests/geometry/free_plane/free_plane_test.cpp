#include "geometry/free_plane/free_plane.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/geometry/adversarial.hpp"
#include "tests/kit/geometry/visibility_oracle.hpp"

namespace asv::geometry {
namespace {

constexpr Box unit{{0, 0}, {1, 1}};
constexpr double infinity = std::numeric_limits<double>::infinity();

double shortest(const std::vector<Box>& boxes, const Point& from, const Point& to) {
    return FreePlane(boxes, unit).shortest_path(from, to);
}

TEST(FreePlane, StraightWhereNothingIsInTheWay) {
    EXPECT_DOUBLE_EQ(shortest({}, {0.1, 0.1}, {0.4, 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(shortest({{{0.6, 0.6}, {0.7, 0.7}}}, {0.1, 0.1}, {0.4, 0.5}), 0.5);
    EXPECT_EQ(shortest({}, {0.3, 0.3}, {0.3, 0.3}), 0);
}

TEST(FreePlane, RoundABox) {
    const std::vector<Box> boxes{{{0.4, 0.2}, {0.6, 0.6}}};
    const double over = 2 * std::hypot(0.2, 0.1) + 0.2;
    EXPECT_NEAR(shortest(boxes, {0.2, 0.5}, {0.8, 0.5}), over, 1e-15);
    EXPECT_NEAR(shortest(boxes, {0.4, 0.5}, {0.6, 0.5}), 0.4, 1e-15) << "starts on the wall";
}

TEST(FreePlane, ThePathHasTheLengthAndBendsAtCorners) {
    const std::vector<Box> boxes{{{0.3, 0.0}, {0.35, 0.8}}, {{0.6, 0.2}, {0.65, 1.0}}};
    FreePlane space(boxes, unit);
    const Point from{0.1, 0.1}, to{0.9, 0.9};
    const auto points = space.shortest_path_points(from, to, 1000);
    const std::vector<Point> expected{from, {0.3, 0.8}, {0.35, 0.8}, {0.6, 0.2}, {0.65, 0.2}, to};
    EXPECT_EQ(points, expected);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    EXPECT_NEAR(length, space.shortest_path(from, to), 1e-15);
    EXPECT_TRUE(space.shortest_path_points(from, to, 0).empty()) << "too much to look at";
    EXPECT_TRUE(space.shortest_path_points(from, {0.32, 0.5}, 1000).empty()) << "in a box";
}

TEST(FreePlane, AlongWallsIsAllowed) {
    const std::vector<Box> boxes{{{0.2, 0.0}, {0.4, 0.5}}, {{0.6, 0.0}, {0.8, 0.5}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.1, 0.5}, {0.9, 0.5}), 0.8);
    const std::vector<Box> zigzag{{{0.2, 0.1}, {0.4, 0.5}}, {{0.6, 0.5}, {0.8, 0.9}}};
    EXPECT_DOUBLE_EQ(shortest(zigzag, {0.1, 0.5}, {0.9, 0.5}), 0.8) << "a wall on either side";
}

TEST(FreePlane, BoxesThatTouchAreSealed) {
    const std::vector<Box> side{{{0.3, 0.2}, {0.5, 0.7}}, {{0.5, 0.2}, {0.7, 0.7}}};
    EXPECT_NEAR(shortest(side, {0.5, 0.1}, {0.5, 0.8}), 2 * std::hypot(0.2, 0.1) + 0.5, 1e-15);
    const std::vector<Box> corner{{{0, 0.2}, {0.5, 0.4}}, {{0.5, 0.4}, {1, 0.6}}};
    EXPECT_EQ(shortest(corner, {0.1, 0.1}, {0.9, 0.9}), infinity);
    const std::vector<Box> border{{{0.3, 0.0}, {0.5, 0.7}}};
    EXPECT_NEAR(shortest(border, {0.2, 0.0}, {0.6, 0.0}), 2 * std::hypot(0.1, 0.7) + 0.2, 1e-15);
}

TEST(FreePlane, TheSmallestGapIsOpen) {
    const double beside = std::nextafter(0.5, 1.0);
    const std::vector<Box> boxes{{{0, 0.4}, {0.5, 0.6}}, {{beside, 0.4}, {1, 0.6}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.5, 0.1}, {0.5, 0.9}), 0.8);
}

TEST(FreePlane, CoveredPointsAreNotConnected) {
    FreePlane space(std::vector<Box>{{{0.4, 0.4}, {0.6, 0.6}}}, unit);
    EXPECT_FALSE(space.is_free({0.5, 0.5}));
    EXPECT_TRUE(space.is_free({0.4, 0.5}));
    EXPECT_FALSE(space.is_free({1.1, 0.5}));
    EXPECT_FALSE(space.connected({0.5, 0.5}, {0.1, 0.1}));
    EXPECT_EQ(space.shortest_path({0.5, 0.5}, {0.5, 0.5}), infinity);
    EXPECT_EQ(space.shortest_path({0.1, 0.1}, {1.1, 0.5}), infinity);
}

TEST(FreePlane, BoxesWithoutInteriorAreIgnored) {
    const std::vector<Box> boxes{
        {{0.5, 0.0}, {0.5, 1.0}}, {{0.7, 0.0}, {0.6, 1.0}}, {{0.3, 0.3}, {0.3, 0.3}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.1, 0.5}, {0.9, 0.5}), 0.8);
}

/// A square spiral of touching walls 0.1 thick, its way 0.1 wide.
std::vector<Box> spiral() {
    return {{{0.0, 0.1}, {0.9, 0.2}}, {{0.8, 0.2}, {0.9, 0.9}}, {{0.1, 0.8}, {0.8, 0.9}},
            {{0.1, 0.3}, {0.2, 0.8}}, {{0.2, 0.3}, {0.7, 0.4}}, {{0.6, 0.4}, {0.7, 0.7}},
            {{0.3, 0.6}, {0.6, 0.7}}};
}

TEST(FreePlane, FollowsASpiral) {
    const std::vector<Box> boxes = spiral();
    const double expected = oracle::shortest_path(boxes, unit, {0.05, 0.05}, {0.45, 0.5}, 1e-9);
    EXPECT_GT(expected, 4);
    EXPECT_NEAR(shortest(boxes, {0.05, 0.05}, {0.45, 0.5}), expected, 1e-7);
}

/// Scenes on a grid of integers, where sides, corners and borders coincide all the time.
class GridScene {
  public:
    static constexpr int side = 12;

    explicit GridScene(std::uint64_t seed) : engine_(seed) {
        const int count = draw(0, 14);
        for (int i = 0; i < count; ++i) {
            const int x = draw(-1, side - 1);
            const int y = draw(-1, side - 1);
            boxes.push_back({{real(x), real(y)}, {real(x + draw(0, 6)), real(y + draw(0, 6))}});
        }
    }

    Point draw_point() { return {draw(0, side - 1) + 0.5, draw(0, side - 1) + 0.5}; }
    int draw(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }

    /// The number of the component of unit square (x, y), 0 where a box covers it.
    std::vector<int> components() const {
        std::vector<int> label(side * side, -1);
        for (int i = 0; i < side * side; ++i) {
            const Point middle{i % side + 0.5, i / side + 0.5};
            for (const Box& box : boxes) {
                if (contains(box, middle)) label[index(i)] = 0;
            }
        }
        int next = 1;
        for (int i = 0; i < side * side; ++i) {
            if (label[index(i)] == -1) flood(label, i, next++);
        }
        return label;
    }

    static int square(const Point& point) {
        return static_cast<int>(point.y) * side + static_cast<int>(point.x);
    }
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    Box bounds{{0, 0}, {side, side}};
    std::vector<Box> boxes;

  private:
    static double real(int i) { return static_cast<double>(i); }

    static void flood(std::vector<int>& label, int from, int number) {
        if (label[index(from)] != -1) return;
        label[index(from)] = number;
        if (from % side > 0) flood(label, from - 1, number);
        if (from % side < side - 1) flood(label, from + 1, number);
        if (from >= side) flood(label, from - side, number);
        if (from < side * (side - 1)) flood(label, from + side, number);
    }

    std::mt19937_64 engine_;
};

TEST(FreePlane, AgreesWithBruteForceOnAGrid) {
    std::size_t bent = 0;
    for (std::uint64_t seed = 1; seed <= test_count(3000); ++seed) {
        GridScene scene(seed);
        FreePlane space(scene.boxes, scene.bounds);
        const std::vector<int> label = scene.components();
        for (int i = 0; i < 6; ++i) {
            const Point from = scene.draw_point();
            const Point to = scene.draw_point();
            const int component = label[GridScene::index(GridScene::square(from))];
            const bool joined =
                component != 0 && component == label[GridScene::index(GridScene::square(to))];
            ASSERT_EQ(space.connected(from, to), joined) << "seed " << seed << ", pair " << i;
            const double found = space.shortest_path(from, to);
            if (!joined) {
                ASSERT_EQ(found, infinity) << "seed " << seed << ", pair " << i;
                continue;
            }
            const double expected =
                oracle::shortest_path(scene.boxes, scene.bounds, from, to, 1e-7);
            ASSERT_NEAR(found, expected, 1e-5) << "seed " << seed << ", pair " << i;
            if (found > std::hypot(from.x - to.x, from.y - to.y) + 1e-6) ++bent;
        }
    }
    EXPECT_GT(bent, test_count(2000)) << "the scenes do not ask enough";
}

double draw_real(std::mt19937_64& engine) {
    return static_cast<double>(engine() >> 11) * 0x1p-53;
}

std::vector<Box> random_boxes(std::mt19937_64& engine, std::size_t count, double largest) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Point low{draw_real(engine) * 1.2 - 0.1, draw_real(engine) * 1.2 - 0.1};
        boxes.push_back(
            {low, {low.x + largest * draw_real(engine), low.y + largest * draw_real(engine)}});
    }
    return boxes;
}

TEST(FreePlane, AgreesWithBruteForceInGeneralPosition) {
    for (std::uint64_t seed = 1; seed <= test_count(400); ++seed) {
        std::mt19937_64 engine(seed);
        const std::vector<Box> boxes = random_boxes(engine, 5 + seed % 40, 0.25);
        FreePlane space(boxes, unit);
        for (int i = 0; i < 4; ++i) {
            const Point from{draw_real(engine), draw_real(engine)};
            const Point to{draw_real(engine), draw_real(engine)};
            if (!space.is_free(from) || !space.is_free(to)) continue;
            const double expected = oracle::shortest_path(boxes, unit, from, to, 0);
            const double found = space.shortest_path(from, to);
            if (std::isinf(expected)) {
                ASSERT_EQ(found, infinity) << "seed " << seed << ", pair " << i;
            } else {
                ASSERT_NEAR(found, expected, 1e-11) << "seed " << seed << ", pair " << i;
            }
        }
    }
}

TEST(FreePlane, MirroredTurnedAndSwapped) {
    for (std::uint64_t seed = 1; seed <= test_count(200); ++seed) {
        GridScene scene(seed);
        const Point from = scene.draw_point();
        const Point to = scene.draw_point();
        const double expected = FreePlane(scene.boxes, scene.bounds).shortest_path(from, to);
        constexpr double side = GridScene::side;
        const auto turn = [](const Point& p) { return Point{side - p.y, p.x}; };
        const auto mirror = [](const Point& p) { return Point{p.y, p.x}; };
        std::vector<Box> turned;
        std::vector<Box> mirrored;
        for (const Box& box : scene.boxes) {
            turned.push_back({{side - box.high.y, box.low.x}, {side - box.low.y, box.high.x}});
            mirrored.push_back({mirror(box.low), mirror(box.high)});
        }
        const auto check = [&](double found, const char* how) {
            if (std::isinf(expected)) {
                ASSERT_EQ(found, infinity) << how << ", seed " << seed;
            } else {
                ASSERT_NEAR(found, expected, 1e-12) << how << ", seed " << seed;
            }
        };
        check(FreePlane(scene.boxes, scene.bounds).shortest_path(to, from), "swapped");
        check(FreePlane(turned, scene.bounds).shortest_path(turn(from), turn(to)), "turned");
        check(FreePlane(mirrored, scene.bounds).shortest_path(mirror(from), mirror(to)),
              "mirrored");
    }
}

TEST(FreePlane, AnotherBoxNeverShortens) {
    for (std::uint64_t seed = 1; seed <= test_count(100); ++seed) {
        std::mt19937_64 engine(seed);
        const std::vector<Box> boxes = random_boxes(engine, 30, 0.25);
        const Point from{draw_real(engine), draw_real(engine)};
        const Point to{draw_real(engine), draw_real(engine)};
        double before = 0;
        for (std::size_t count = 0; count <= boxes.size(); ++count) {
            const double now =
                FreePlane(std::span(boxes).first(count), unit).shortest_path(from, to);
            ASSERT_GE(now, before * (1 - 1e-13)) << "seed " << seed << ", " << count << " boxes";
            before = now;
        }
    }
}

TEST(FreePlane, LaterQuestionsGetTheSameAnswers) {
    for (std::uint64_t seed = 1; seed <= test_count(100); ++seed) {
        std::mt19937_64 engine(seed);
        const std::vector<Box> boxes = random_boxes(engine, 60, 0.2);
        FreePlane kept(boxes, unit);
        for (int i = 0; i < 10; ++i) {
            const Point from{draw_real(engine), draw_real(engine)};
            const Point to{draw_real(engine), draw_real(engine)};
            ASSERT_EQ(kept.shortest_path(from, to), FreePlane(boxes, unit).shortest_path(from, to))
                << "seed " << seed << ", pair " << i;
        }
    }
}

TEST(FreePlane, LessEffortBoundsFromBelow) {
    std::mt19937_64 engine(3);
    FreePlane space(random_boxes(engine, 2000, 0.02), unit);
    const Point from{0.01, 0.02};
    const Point to{0.99, 0.98};
    const double exact = space.shortest_path(from, to);
    ASSERT_TRUE(std::isfinite(exact));
    double before = std::hypot(0.98, 0.96);
    for (std::size_t effort = 0; effort < 1'000'000; effort = 2 * effort + 1) {
        const double now = space.shortest_path_at_least(from, to, effort);
        ASSERT_GE(now, before * (1 - 1e-13));
        ASSERT_LE(now, exact * (1 + 1e-13));
        before = now;
    }
    EXPECT_EQ(before, exact);
    EXPECT_LT(space.shortest_path_at_least(from, to, 10), exact);
}

TEST(FreePlane, ManyBoxes) {
    for (const double largest : {0.0005, 0.003, 0.02}) {
        std::mt19937_64 engine(5);
        FreePlane space(random_boxes(engine, 100'000, largest), unit);
        const Point from{0.1, 0.1};
        const Point to{0.9, 0.8};
        const double length = space.shortest_path_at_least(from, to, 200'000);
        EXPECT_EQ(std::isfinite(length), space.connected(from, to));
        EXPECT_GE(length, std::hypot(0.8, 0.7));
    }
    std::mt19937_64 engine(5);
    FreePlane space(random_boxes(engine, 100'000, 0.0005), unit);
    const double length = space.shortest_path({0.1, 0.1}, {0.9, 0.8});
    ASSERT_TRUE(std::isfinite(length));
    EXPECT_NEAR(space.shortest_path({0.9, 0.8}, {0.1, 0.1}), length, 1e-12);
}

}  // namespace
}  // namespace asv::geometry
