#include "core/solve/bodies/point_geodesic.hpp"

#include "core/bounds/lower_bound.hpp"
#include "core/space/joint_space.hpp"
#include "geometry/free_plane/free_plane.hpp"

namespace asv::core {

namespace {

/// A proof wants a way between the point and what it passes; start and goal are at least twice as
/// far from everything as this share of that (Margins::slack).
constexpr double share_of_slack = 0.5;

std::vector<Point> taut_path(const JointWorld& world) {
    const ChainConstraints& keep = world.constraints;
    const double contact = share_of_slack * Margins{}.slack * keep.extent;
    std::vector<Box> boxes;
    for (const Box& box : keep.obstacles) boxes.push_back(geometry::grown(box, contact));
    geometry::FreePlane plane(boxes, geometry::grown(keep.bounds, -contact));
    return plane.shortest_path_points({world.start[0], world.start[1]},
                                      {world.goal[0], world.goal[1]}, max_bound_effort);
}

bool proven(const JointWorld& world, const Configurations& path) {
    JointSpace space(world);
    const auto row = [&](std::size_t i) { return std::span(path).subspan(2 * i, 2); };
    for (std::size_t i = 1; 2 * i < path.size(); ++i)
        if (!space.motion_valid(row(i - 1), row(i))) return false;
    return true;
}

}  // namespace

Configurations point_geodesic(const JointWorld& world) {
    Configurations path;
    for (const Point& point : taut_path(world)) path.insert(path.end(), {point.x, point.y});
    return proven(world, path) ? path : Configurations{};
}

}  // namespace asv::core
