#include "asv/core/space/obstacle_field.hpp"

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
    : boxes_(boxes.begin(), boxes.end()), index_(boxes_) {
    if (few())
        for (const Box& box : boxes_) all_.push_back(box);
}

const NearBoxes& ObstacleField::near(const Box& region, NearBoxes& scratch) const {
    if (few()) return all_;
    scratch.clear();
    index_.visit(region, [&](std::size_t i) {
        scratch.push_back(boxes_[i]);
        return false;
    });
    return scratch;
}

bool ObstacleField::contains(const geometry::Point& point) const {
    return index_.visit(Box{point, point}, [](std::size_t) { return true; });
}

}  // namespace asv::core
