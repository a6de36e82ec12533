#include "io/drawing/path_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/cost.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

double length(const Point& a, const Point& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

Point nearest_in_box(const Point& point, const Box& box) {
    return {std::clamp(point.x, box.low.x, box.high.x), std::clamp(point.y, box.low.y, box.high.y)};
}

Point nearest_on_segment(const Point& point, const Segment& segment) {
    const double dx = segment.b.x - segment.a.x;
    const double dy = segment.b.y - segment.a.y;
    const double squared = dx * dx + dy * dy;
    if (squared == 0) return segment.a;
    const double along = ((point.x - segment.a.x) * dx + (point.y - segment.a.y) * dy) / squared;
    const double t = std::clamp(along, 0.0, 1.0);
    return {segment.a.x + t * dx, segment.a.y + t * dy};
}

/// The middle of the part of the segment that lies in the box (Liang and Barsky 1984).
Point middle_of_common_part(const Segment& segment, const Box& box) {
    double from = 0;
    double to = 1;
    const auto clip = [&](double start, double delta, double low, double high) {
        if (delta == 0) return;
        const double first = (low - start) / delta;
        const double second = (high - start) / delta;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    };
    const double dx = segment.b.x - segment.a.x;
    const double dy = segment.b.y - segment.a.y;
    clip(segment.a.x, dx, box.low.x, box.high.x);
    clip(segment.a.y, dy, box.low.y, box.high.y);
    const double t = (from + to) / 2;
    return {segment.a.x + t * dx, segment.a.y + t * dy};
}

/// Never more than the distance: the gap between the bounding boxes.
double lower_bound(const Segment& segment, const Box& box) {
    const double dx = std::max({0.0, box.low.x - std::max(segment.a.x, segment.b.x),
                                std::min(segment.a.x, segment.b.x) - box.high.x});
    const double dy = std::max({0.0, box.low.y - std::max(segment.a.y, segment.b.y),
                                std::min(segment.a.y, segment.b.y) - box.high.y});
    return std::hypot(dx, dy);
}

/// The obstacle nearest to one broom while it moves. All obstacles are looked at only when the
/// broom has left the radius of the last full look: until then no point of it has moved further
/// than the radius, so that an obstacle beyond (nearest then + 2 * radius) cannot be the nearest
/// now.
class NearestObstacle {
  public:
    NearestObstacle(const std::vector<Box>& obstacles, double min_radius)
        : obstacles_(obstacles), min_radius_(min_radius) {}

    /// The index and the distance of the nearest. Precondition: there are obstacles.
    std::pair<std::size_t, double> operator()(const Segment& broom) {
        const bool still_near = !candidates_.empty() && length(anchor_.a, broom.a) <= radius_ &&
                                length(anchor_.b, broom.b) <= radius_;
        if (!still_near) look_at_all(broom);
        return nearest_of(candidates_, broom);
    }

  private:
    template <class Indices>
    std::pair<std::size_t, double> nearest_of(const Indices& indices, const Segment& broom) const {
        std::pair<std::size_t, double> best{0, std::numeric_limits<double>::infinity()};
        for (const std::size_t i : indices) {
            if (lower_bound(broom, obstacles_[i]) >= best.second) continue;
            const double distance = geometry::distance(broom, obstacles_[i]);
            if (distance < best.second) best = {i, distance};
        }
        return best;
    }

    void look_at_all(const Segment& broom) {
        if (all_.empty()) {
            all_.resize(obstacles_.size());
            for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = i;
        }
        anchor_ = broom;
        const double nearest = nearest_of(all_, broom).second;
        radius_ = std::max(min_radius_, nearest / 2);
        candidates_.clear();
        for (std::size_t i = 0; i < obstacles_.size(); ++i) {
            if (lower_bound(broom, obstacles_[i]) <= nearest + 2 * radius_)
                candidates_.push_back(i);
        }
    }

    const std::vector<Box>& obstacles_;
    double min_radius_;
    double radius_ = 0;
    Segment anchor_;
    std::vector<std::size_t> candidates_;
    std::vector<std::size_t> all_;
};

double turn_at(std::span<const Point> state, std::size_t i) {
    const std::size_t n = state.size();
    const Point& before = state[(i + n - 1) % n];
    const Point& here = state[i];
    const Point& after = state[(i + 1) % n];
    const Point in{here.x - before.x, here.y - before.y};
    const Point out{after.x - here.x, after.y - here.y};
    return std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y);
}

void measure_shape(std::span<const Point> state, StateMeasures& measures) {
    measures.area = std::abs(geometry::signed_area(state));
    if (state.size() < 3) return;
    double tightest = -1;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const double turn = std::abs(turn_at(state, i));
        if (turn <= tightest) continue;
        tightest = turn;
        measures.tightest_asv = i;
    }
    measures.tightest_turn = tightest;
}

}  // namespace

Segment broom_of(std::span<const Point> state, std::size_t broom) {
    return {state[broom], state[std::min(broom + 1, state.size() - 1)]};
}

double link_length(const core::Problem& problem) {
    if (const core::PlanarArm* arm = problem.arm()) return arm->links[0];
    if (problem.body_kind() == core::BodyKind::point) return 50 * problem.requirements.max_step;
    return problem.requirements.broom_length;
}

std::size_t broom_count(std::size_t asv_count) {
    return std::max<std::size_t>(asv_count, 2) - 1;
}

Segment shortest_link(const Segment& segment, const Box& box) {
    if (geometry::distance(segment, box) == 0) {
        const Point common = middle_of_common_part(segment, box);
        return {common, common};
    }
    const std::array<Point, 4> corners{
        {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}};
    Segment best{segment.a, nearest_in_box(segment.a, box)};
    const auto consider = [&](const Segment& link) {
        if (length(link.a, link.b) < length(best.a, best.b)) best = link;
    };
    consider({segment.b, nearest_in_box(segment.b, box)});
    for (const Point& corner : corners) consider({nearest_on_segment(corner, segment), corner});
    return best;
}

std::vector<StateMeasures> measure(const core::Problem& problem, const core::Path& path) {
    std::vector<StateMeasures> result(path.size());
    const double min_radius = link_length(problem) / 2;
    std::vector<NearestObstacle> nearest(broom_count(path.asv_count()),
                                         NearestObstacle(problem.obstacles, min_radius));
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto state = path.state(i);
        if (problem.body_kind() == core::BodyKind::chain) measure_shape(state, result[i]);
        if (i > 0)
            result[i].cost =
                result[i - 1].cost + core::step_cost(problem, path.state(i - 1), state);
        if (problem.obstacles.empty()) continue;
        Clearance clearance;
        for (std::size_t broom = 0; broom < nearest.size(); ++broom) {
            const auto [obstacle, distance] = nearest[broom](broom_of(state, broom));
            if (distance < clearance.distance) clearance = {distance, broom, obstacle};
        }
        result[i].clearance = clearance;
    }
    return result;
}

}  // namespace asv::io
