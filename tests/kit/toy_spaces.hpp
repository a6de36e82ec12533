#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "tests/kit/chains/configurations.hpp"

/// Spaces small enough to see through, which the planners work in as they do in that of the chain.

namespace asv::test {

using geometry::Box;

/// A point in the unit square among closed boxes. It remembers how it was steered.
struct PointSpace {
    explicit PointSpace(std::vector<Box> given) : boxes(std::move(given)) {}

    std::size_t dimension() const { return 2; }
    core::WrappingAngles wrapping() const { return {}; }
    core::NearestNeighbours make_index() const { return {Row{1, 1}, {}}; }
    double distance(std::span<const double> a, std::span<const double> b) const {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    }
    bool free(std::span<const double> from, std::span<const double> to) const {
        for (const Box& box : boxes)
            if (geometry::meets(geometry::Segment{{from[0], from[1]}, {to[0], to[1]}}, box))
                return false;
        return true;
    }
    bool sample(core::Rng& rng, std::span<double> row) {
        row[0] = rng.uniform();
        row[1] = rng.uniform();
        return free(row, row);
    }
    /// In strides of 0.05, as far as they are free.
    core::Steered steer(std::span<const double> from, std::span<const double> target,
                        core::Configurations& visited) {
        steered.emplace_back(Row(from.begin(), from.end()), Row(target.begin(), target.end()));
        Row at(from.begin(), from.end());
        core::Steered outcome = core::Steered::trapped;
        while (true) {
            const double left = distance(at, target);
            const Row next =
                left <= 0.05 ? Row(target.begin(), target.end()) : between(at, target, 0.05 / left);
            if (!free(at, next)) return outcome;
            visited.insert(visited.end(), next.begin(), next.end());
            if (left <= 0.05) return core::Steered::reached;
            outcome = core::Steered::advanced;
            at = next;
        }
    }

    bool from_unit_cube(std::span<const double> unit, std::span<double> row) const {
        std::copy(unit.begin(), unit.end(), row.begin());
        return true;
    }
    double extent(std::size_t) const { return 1; }
    void perturb(core::Rng& rng, std::span<const double> row, double sigma,
                 std::span<double> out) const {
        for (std::size_t i = 0; i < 2; ++i) out[i] = row[i] + sigma * rng.normal();
    }
    bool collides(std::span<const double> row) const { return !valid(row); }
    bool valid(std::span<const double> row) const {
        const auto inside = [](double x) { return x >= 0 && x <= 1; };
        return inside(row[0]) && inside(row[1]) && free(row, row);
    }
    bool motion_valid(std::span<const double> from, std::span<const double> to) {
        ++motion_checks;
        return valid(from) && valid(to) && free(from, to);
    }
    double cost(std::span<const double> from, std::span<const double> to) const {
        return distance(from, to);
    }
    double cost_lower_bound(std::span<const double> from, std::span<const double> to) const {
        return distance(from, to);
    }

    std::size_t asv_count() const { return 1; }
    std::optional<Point> pull_target(core::Rng& rng, double) {
        Row row(2);
        if (!sample(rng, row)) return std::nullopt;
        return Point{row[0], row[1]};
    }
    Point position(std::span<const double> row, std::size_t) const { return {row[0], row[1]}; }
    core::Steered pull(std::span<const double> from, std::size_t, const Point& target,
                       core::Configurations& visited) {
        ++pulls;
        return steer(from, Row{target.x, target.y}, visited);
    }

    std::vector<Point> guide() const { return way; }
    bool sample_near(core::Rng& rng, const Point& point, std::span<double> row) {
        row[0] = point.x + 0.02 * rng.normal();
        row[1] = point.y + 0.02 * rng.normal();
        return free(row, row);
    }

    std::vector<Point> way;  ///< what guide() says
    std::vector<Box> boxes;
    std::vector<std::pair<Row, Row>> steered;  ///< from, target
    std::size_t pulls = 0;
    std::size_t motion_checks = 0;
};

/// A wall across the square but for a door 0.02 wide near its upper end.
inline std::vector<Box> wall_with_door() {
    return {{{0.45, -1}, {0.55, 0.90}}, {{0.45, 0.92}, {0.55, 2}}};
}

/// A closed wall: start and goal in different halves never meet.
inline std::vector<Box> closed_wall() {
    return {{{0.45, -1}, {0.55, 2}}};
}

/// A place x in [0, 1] and an angle; no obstacle, but one motion turns by at most a radian.
struct DialSpace {
    std::size_t dimension() const { return 2; }
    core::WrappingAngles wrapping() const { return {1, 1}; }
    core::NearestNeighbours make_index() const { return {Row{1, 1}, {1, 1}}; }
    double distance(std::span<const double> a, std::span<const double> b) const {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    }
    bool sample(core::Rng& rng, std::span<double> row) {
        row[0] = rng.uniform();
        row[1] = rng.uniform(-4, 4);
        return true;
    }
    core::Steered steer(std::span<const double> from, std::span<const double> target,
                        core::Configurations& visited) {
        const double turn = std::abs(target[1] - from[1]);
        const bool near = turn <= 1;
        const Row next = between(from, target, near ? 1 : 1 / turn);
        visited.insert(visited.end(), next.begin(), next.end());
        return near ? core::Steered::reached : core::Steered::advanced;
    }
};

static_assert(core::SampledSpace<PointSpace>);
static_assert(core::ConfigurationSpace<DialSpace>);

}  // namespace asv::test
