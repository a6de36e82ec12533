#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/free_plane/free_plane.hpp"
#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/visibility_oracle.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

/// Scenes in which sides, corners and borders coincide, against brute force and under symmetries.

namespace asv::geometry {
namespace {

/// Scenes on a grid of integers, where sides, corners and borders coincide all the time.
class GridScene {
  public:
    static constexpr int side = 12;

    explicit GridScene(std::uint64_t seed) : random_(seed) {
        const int count = draw(0, 14);
        for (int i = 0; i < count; ++i) {
            const int x = draw(-1, side - 1);
            const int y = draw(-1, side - 1);
            boxes.push_back({{real(x), real(y)}, {real(x + draw(0, 6)), real(y + draw(0, 6))}});
        }
    }

    Point draw_point() { return {draw(0, side - 1) + 0.5, draw(0, side - 1) + 0.5}; }
    int draw(int low, int high) { return low + random_.pick(high - low + 1); }

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

    test::Random random_;
};

TEST(FreePlane, AgreesWithBruteForceOnAGrid) {
    std::size_t bent = 0;
    for (std::uint64_t seed = 1; seed <= test::scaled(3000); ++seed) {
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
                test::brute_force_shortest_path(scene.boxes, scene.bounds, from, to, 1e-7);
            ASSERT_NEAR(found, expected, 1e-5) << "seed " << seed << ", pair " << i;
            if (found > std::hypot(from.x - to.x, from.y - to.y) + 1e-6) ++bent;
        }
    }
    EXPECT_GT(bent, test::scaled(2000)) << "the scenes do not ask enough";
}

TEST(FreePlane, MirroredTurnedAndSwapped) {
    for (std::uint64_t seed = 1; seed <= test::scaled(200); ++seed) {
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

}  // namespace
}  // namespace asv::geometry
