#include "core/space/proof/kept_obstacles.hpp"

#include <algorithm>
#include <utility>

namespace asv::core {

namespace {

using geometry::Box;

std::vector<std::uint32_t> numbers_of_kept(std::span<const Box> obstacles, double tolerance) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < obstacles.size(); ++i)
        if (!geometry::is_empty(geometry::grown(obstacles[i], -tolerance))) numbers.push_back(i);
    return numbers;
}

std::vector<Box> grown(std::span<const Box> obstacles, const std::vector<std::uint32_t>& numbers,
                       double margin) {
    std::vector<Box> boxes;
    boxes.reserve(numbers.size());
    for (const std::uint32_t i : numbers) boxes.push_back(geometry::grown(obstacles[i], margin));
    return boxes;
}

}  // namespace

KeptObstacles::KeptObstacles(std::span<const Box> obstacles, double tolerance, double margin)
    : numbers_(numbers_of_kept(obstacles, tolerance)), field_(grown(obstacles, numbers_, margin)) {}

std::shared_ptr<const ObstacleField> field_of(std::span<const Box> boxes,
                                              std::shared_ptr<const KeptObstacles> prepared) {
    const auto holds = [boxes](std::span<const Box> others) {
        return std::equal(boxes.begin(), boxes.end(), others.begin(), others.end());
    };
    if (!prepared || !holds(prepared->field().boxes()))
        return std::make_shared<ObstacleField>(boxes);
    const ObstacleField* field = &prepared->field();
    return {std::move(prepared), field};
}

}  // namespace asv::core
