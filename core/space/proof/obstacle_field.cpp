#include "core/space/proof/obstacle_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core {

using geometry::Box;

void NearBoxes::clear() {
    for (auto* array : {&low_x, &low_y, &high_x, &high_y}) array->clear();
}

void NearBoxes::push_back(const Box& box) {
    low_x.push_back(box.low.x);
    low_y.push_back(box.low.y);
    high_x.push_back(box.high.x);
    high_y.push_back(box.high.y);
}

ObstacleField::ObstacleField(std::span<const Box> boxes)
    : boxes_(boxes.begin(), boxes.end()),
      index_(boxes_),
      spacing_(std::numeric_limits<double>::infinity()) {
    if (few()) {
        for (const Box& box : boxes_) all_.push_back(box);
        return;
    }
    Box hull = boxes_.front();
    for (const Box& box : boxes_) {
        hull.low = {std::min(hull.low.x, box.low.x), std::min(hull.low.y, box.low.y)};
        hull.high = {std::max(hull.high.x, box.high.x), std::max(hull.high.y, box.high.y)};
    }
    spacing_ = std::sqrt((hull.high.x - hull.low.x) * (hull.high.y - hull.low.y) /
                         static_cast<double>(boxes_.size()));
}

bool ObstacleField::contains(const geometry::Point& point) const {
    return index_.visit(Box{point, point}, [](std::size_t) { return true; });
}

}  // namespace asv::core
