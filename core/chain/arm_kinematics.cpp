#include "core/chain/arm_kinematics.hpp"

#include <numeric>

#include "core/chain/chain.hpp"

namespace asv::core {

void arm_configuration(const PlanarArm& arm, const geometry::Point& base,
                       std::span<const double> angles, std::span<double> row) {
    const bool headings = arm.angles == AngleReference::x_axis;
    row[0] = base.x;
    row[1] = base.y;
    row[2] = angles[0];
    for (std::size_t i = 1; i < angles.size(); ++i)
        row[2 + i] = headings ? angles[i] - angles[i - 1] : angles[i];
}

std::vector<geometry::Point> arm_points(const PlanarArm& arm, const geometry::Point& base,
                                        std::span<const double> angles) {
    const Chain chain(arm.links);
    std::vector<double> row(chain.dimension());
    arm_configuration(arm, base, angles, row);
    Pose pose = chain.make_pose();
    chain.forward(row, pose);
    std::vector<geometry::Point> points(chain.asv_count());
    copy_positions(pose, points);
    return points;
}

}  // namespace asv::core
