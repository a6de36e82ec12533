#include "core/space/joint_world.hpp"

#include <algorithm>
#include <numbers>

#include "core/chain/arm_kinematics.hpp"
#include "core/search/trees/interpolate.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

std::span<const double> link_lengths(const Problem& problem) {
    const PlanarArm* arm = problem.arm();
    return arm ? std::span<const double>(arm->links) : std::span<const double>();
}

std::vector<JointCoordinate> coordinates_of(const Problem& problem, const Box& bounds) {
    const PlanarArm* arm = problem.arm();
    if (!arm)
        return {{0, bounds.low.x, bounds.high.x, false}, {1, bounds.low.y, bounds.high.y, false}};
    std::vector<JointCoordinate> coordinates;
    for (std::size_t i = 0; i < arm->joints.size(); ++i) {
        const JointRange& range = arm->joints[i];
        coordinates.push_back({i, range.wraps ? 0 : range.low,
                               range.wraps ? 2 * std::numbers::pi : range.high, range.wraps});
    }
    std::stable_partition(coordinates.begin(), coordinates.end(),
                          [](const JointCoordinate& c) { return c.wraps; });
    return coordinates;
}

std::vector<double> row_of(const Problem& problem, bool goal,
                           const std::vector<JointCoordinate>& coordinates) {
    const PlanarArm* arm = problem.arm();
    const Point& place = (goal ? problem.goal : problem.start)[0];
    const std::vector<double> values =
        arm ? (goal ? arm->goal : arm->start) : std::vector<double>{place.x, place.y};
    std::vector<double> row;
    for (const JointCoordinate& c : coordinates) row.push_back(values[c.joint]);
    return row;
}

/// The joint angles of an arm's points, up to full turns, or x and y of a point.
std::vector<double> values_of(const Problem& problem, std::span<const Point> state) {
    const PlanarArm* arm = problem.arm();
    if (!arm) return {state[0].x, state[0].y};
    std::vector<double> angles;
    double before = 0;
    for (std::size_t i = 1; i < state.size(); ++i) {
        const double heading =
            elementary::atan2(state[i].y - state[i - 1].y, state[i].x - state[i - 1].x);
        const bool relative = arm->angles == AngleReference::previous_link;
        angles.push_back(relative ? heading - before : heading);
        before = heading;
    }
    return angles;
}

}  // namespace

JointWorld::JointWorld(const Problem& given, const std::shared_ptr<const KeptObstacles>& prepared)
    : problem(given),
      coordinates(),
      chain(link_lengths(problem)),
      constraints(make_joint_constraints(problem, chain, {}, prepared.get())),
      shared_field(field_of(constraints.obstacles, prepared)),
      field(*shared_field) {
    coordinates = coordinates_of(problem, constraints.bounds);
    start = row_of(problem, false, coordinates);
    goal = row_of(problem, true, coordinates);
}

std::size_t JointWorld::wrapping_count() const {
    return static_cast<std::size_t>(std::count_if(
        coordinates.begin(), coordinates.end(), [](const JointCoordinate& c) { return c.wraps; }));
}

void JointWorld::chain_row(std::span<const double> row, std::span<double> out) const {
    const PlanarArm* arm = problem.arm();
    if (!arm) {
        std::copy(row.begin(), row.end(), out.begin());
        return;
    }
    arm_configuration(*arm, problem.start[0], values_in_order(row), out);
}

Placement JointWorld::placement(std::span<const double> row) const {
    const PlanarArm* arm = problem.arm();
    if (!arm) return {{{row[0], row[1]}}, {}};
    const std::vector<double> angles = values_in_order(row);
    return {arm_points(*arm, problem.start[0], angles), angles};
}

std::vector<double> JointWorld::values_in_order(std::span<const double> row) const {
    std::vector<double> values(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) values[coordinates[i].joint] = row[i];
    return values;
}

Configurations JointWorld::chain_rows(const Configurations& rows) const {
    const std::size_t from = dimension(), to = chain.dimension();
    Configurations result(rows.size() / from * to);
    for (std::size_t i = 0; i * from < rows.size(); ++i)
        chain_row({rows.data() + i * from, from}, {result.data() + i * to, to});
    return result;
}

Configurations JointWorld::rows_of(const Path& path) const {
    const WrappingAngles all_angles{0, problem.arm() ? dimension() : 0};
    std::vector<double> before = start, row(dimension());
    Configurations rows;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto values = values_of(problem, path.state(i));
        for (std::size_t k = 0; k < row.size(); ++k) row[k] = values[coordinates[k].joint];
        unwrap(row, before, all_angles);
        rows.insert(rows.end(), row.begin(), row.end());
        before = row;
    }
    return rows;
}

bool JointWorld::within_limits(std::span<const double> row) const {
    for (std::size_t i = 0; i < row.size(); ++i) {
        const JointCoordinate& c = coordinates[i];
        if (!c.wraps && !(row[i] >= c.low && row[i] <= c.high)) return false;
    }
    return true;
}

}  // namespace asv::core
