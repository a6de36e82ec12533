#include "tests/kit/geometry/random_boxes.hpp"

namespace asv::test {

namespace {

/// Boxes in and around the unit square whose sides are what side() draws.
template <class Side>
std::vector<geometry::Box> boxes_with_sides(Random& random, std::size_t count, Side&& side) {
    std::vector<geometry::Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(-0.1, 1), y = random.uniform(-0.1, 1);
        const double width = side();
        boxes.push_back({{x, y}, {x + width, y + side()}});
    }
    return boxes;
}

}  // namespace

std::vector<geometry::Box> random_boxes(Random& random, std::size_t count, double largest) {
    return boxes_with_sides(random, count, [&] { return random.uniform(0, largest); });
}

std::vector<geometry::Box> random_boxes_some_thin(Random& random, std::size_t count,
                                                  double largest) {
    return boxes_with_sides(random, count, [&] {
        return random.one_in(8) ? random.uniform(1.5e-5, 2.5e-5) : random.uniform(0, largest);
    });
}

}  // namespace asv::test
