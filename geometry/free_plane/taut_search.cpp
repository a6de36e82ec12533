#include "geometry/free_plane/taut_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "geometry/predicates/orientation.hpp"

namespace asv::geometry::detail {

namespace {

double length(const Point& a, const Point& b) {
    const double x = a.x - b.x;
    const double y = a.y - b.y;
    return std::sqrt(x * x + y * y);
}

/// A ray that bounds what is seen: its line runs from a through b.
struct Ray {
    Point a;
    Point b;
};

/// As orientation, exact; quicker where points coincide or lie on an axis-parallel line, which they
/// often do here and where the filter of orientation can decide nothing.
int side_of(const Ray& ray, const Point& point) {
    if (point == ray.b) return 0;
    const auto sign = [](double a, double b) { return a < b ? 1 : (b < a ? -1 : 0); };
    if (ray.a.x == ray.b.x) return sign(ray.a.y, ray.b.y) * sign(point.x, ray.a.x);
    if (ray.a.y == ray.b.y) return sign(ray.a.x, ray.b.x) * sign(ray.a.y, point.y);
    return orientation(ray.a, ray.b, point);
}

/// Is the point strictly before the portal, seen in the direction that leads through it?
bool is_before(const Point& point, const Portal& portal) {
    switch (portal.side) {
        case Side::east:
            return point.x < portal.right.x;
        case Side::north:
            return point.y < portal.right.y;
        case Side::west:
            return point.x > portal.right.x;
        default:
            return point.y > portal.right.y;
    }
}

/// Can a path that comes straight from the point bend around the corner's obstacle? Only when it
/// comes along one of the two walls; straight down a wall, it bends at the wall's far end.
bool can_bend(const Point& from, const Corner& corner) {
    const double x = (from.x - corner.point.x) * corner.obstacle_x;
    const double y = (from.y - corner.point.y) * corner.obstacle_y;
    return (x > 0 && y <= 0) || (y > 0 && x <= 0);
}

/// Where the ray's line meets the line x = at (vertical) or y = at: the coordinate along it.
double crossing(const Ray& ray, bool vertical, double at) {
    const double dx = ray.b.x - ray.a.x;
    const double dy = ray.b.y - ray.a.y;
    return vertical ? ray.a.y + dy * ((at - ray.a.x) / dx) : ray.a.x + dx * ((at - ray.a.y) / dy);
}

/// A point from which the search looks around: the start or a corner that has been reached.
struct Viewpoint {
    Point point;
    double length = 0;         ///< of the way from the start
    std::uint32_t before = 0;  ///< the viewpoint from which it was reached; 0, the start, of itself
};

/// What is seen from a viewpoint between two rays.
struct View {
    std::uint32_t viewpoint = 0;
    bool all_around = false;  ///< the rays do not matter
    Ray right;
    Ray left;

    bool holds(const Point& point) const {
        return all_around || (side_of(right, point) >= 0 && side_of(left, point) <= 0);
    }
};

/// A view through a portal, both of whose rays meet it, with an angle between them.
struct Cone {
    View view;
    Portal portal;
};

/// What is left to do, by the least length of a path that it can lead to.
struct Task {
    enum class Kind : std::uint8_t { goal, corner, cone };
    double least = 0;
    Kind kind = Kind::goal;
    std::uint32_t index = 0;  ///< of the corner, the cone, or the viewpoint that sees the goal
    friend bool operator<(const Task& a, const Task& b) { return a.least > b.least; }
};

class TautSearch {
  public:
    TautSearch(CellGraph& graph, const Point& start, const Point& goal)
        : graph_(graph), goal_(goal), goal_cells_(graph.cells_at(goal)) {
        viewpoints_.push_back({start, 0, 0});
    }

    /// The length, or what it is at least when more than that many cells would have to be entered.
    double run(std::size_t effort) {
        View everything;
        everything.all_around = true;
        look(everything);
        while (!tasks_.empty()) {
            const Task task = tasks_.top();
            if (task.kind == Task::Kind::goal) last_ = task.index;
            if (task.kind == Task::Kind::goal || entered_ > effort) return task.least;
            tasks_.pop();
            if (task.kind == Task::Kind::corner) {
                expand(reached_[task.index].corner);
            } else {
                enter(task.index, task.least);
            }
        }
        return std::numeric_limits<double>::infinity();
    }

    /// Start, bends and goal, once run() has found the way; else nothing.
    std::vector<Point> path() const {
        if (!last_) return {};
        std::vector<Point> points{goal_};
        for (std::uint32_t i = *last_; i > 0; i = viewpoints_[i].before)
            points.push_back(viewpoints_[i].point);
        points.push_back(viewpoints_[0].point);
        std::reverse(points.begin(), points.end());
        return points;
    }

  private:
    struct Reached {
        double length = std::numeric_limits<double>::infinity();
        std::uint32_t from = 0;  ///< the viewpoint
        Corner corner;
        bool expanded = false;
    };

    void expand(Corner corner);
    void look(const View& view);
    void enter(std::uint32_t cone, double least);
    void pass(const View& view, CellTree::Id cell, double least);
    void meet_contents(const View& view, CellTree::Id cell);
    void reach(const Corner& corner, std::uint32_t from);
    double min_through(const Cone& cone) const;
    void keep(const Cone& cone, double least);

    CellGraph& graph_;
    Point goal_;
    std::vector<CellTree::Id> goal_cells_;
    std::vector<Viewpoint> viewpoints_;
    std::vector<Reached> reached_;
    std::vector<Cone> cones_;
    std::vector<std::uint32_t> unused_cones_;
    std::vector<Cone> at_hand_;
    std::priority_queue<Task> tasks_;
    std::size_t entered_ = 0;            ///< cells, as often as they were
    std::optional<std::uint32_t> last_;  ///< the viewpoint before the goal
};

void TautSearch::expand(Corner corner) {
    Reached& reached = reached_[corner.id];
    if (reached.expanded) return;
    reached.expanded = true;
    const Point at = corner.point;
    const Point from = viewpoints_[reached.from].point;
    const auto viewpoint = static_cast<std::uint32_t>(viewpoints_.size());
    viewpoints_.push_back({at, reached.length, reached.from});
    // A taut path goes on between straight ahead and along the wall that it has not come along.
    const bool came_along_x = (from.x - at.x) * corner.obstacle_x > 0;
    const Ray ahead{from, at};
    const Ray wall{at, came_along_x ? Point{at.x, at.y + corner.obstacle_y}
                                    : Point{at.x + corner.obstacle_x, at.y}};
    const bool bends_left = side_of(ahead, wall.b) > 0;
    look({viewpoint, false, bends_left ? ahead : wall, bends_left ? wall : ahead});
}

void TautSearch::look(const View& view) {
    for (const CellTree::Id cell : graph_.cells_at(viewpoints_[view.viewpoint].point)) {
        meet_contents(view, cell);
        pass(view, cell, 0);
    }
}

void TautSearch::enter(std::uint32_t cone, double least) {
    unused_cones_.push_back(cone);
    at_hand_.push_back(cones_[cone]);
    while (!at_hand_.empty()) {
        const Cone next = at_hand_.back();
        at_hand_.pop_back();
        ++entered_;
        meet_contents(next.view, next.portal.cell);
        pass(next.view, next.portal.cell, least);
    }
}

void TautSearch::pass(const View& view, CellTree::Id cell, double least) {
    const Point at = viewpoints_[view.viewpoint].point;
    for (const Portal& portal : graph_.portals(cell)) {
        if (!is_before(at, portal)) continue;
        Cone cone{{view.viewpoint, false, {at, portal.right}, {at, portal.left}}, portal};
        if (!view.all_around) {
            if (side_of(view.right, portal.left) <= 0 || side_of(view.left, portal.right) >= 0) {
                continue;
            }
            if (side_of(view.right, portal.right) < 0) cone.view.right = view.right;
            if (side_of(view.left, portal.left) > 0) cone.view.left = view.left;
        }
        // What costs no more than the task at hand would be next anyway: it need not be queued.
        const double through = min_through(cone);
        if (through <= least) {
            at_hand_.push_back(cone);
        } else {
            keep(cone, through);
        }
    }
}

void TautSearch::keep(const Cone& cone, double least) {
    auto index = static_cast<std::uint32_t>(cones_.size());
    if (unused_cones_.empty()) {
        cones_.push_back(cone);
    } else {
        index = unused_cones_.back();
        unused_cones_.pop_back();
        cones_[index] = cone;
    }
    tasks_.push({least, Task::Kind::cone, index});
}

void TautSearch::meet_contents(const View& view, CellTree::Id cell) {
    const Viewpoint& from = viewpoints_[view.viewpoint];
    for (const Corner& corner : graph_.corners(cell)) {
        if (can_bend(from.point, corner) && view.holds(corner.point)) reach(corner, view.viewpoint);
    }
    if (std::find(goal_cells_.begin(), goal_cells_.end(), cell) != goal_cells_.end() &&
        view.holds(goal_)) {
        tasks_.push({from.length + length(from.point, goal_), Task::Kind::goal, view.viewpoint});
    }
}

void TautSearch::reach(const Corner& corner, std::uint32_t from) {
    if (corner.id >= reached_.size()) reached_.resize(graph_.corner_limit());
    Reached& reached = reached_[corner.id];
    const Viewpoint& viewpoint = viewpoints_[from];
    const double total = viewpoint.length + length(viewpoint.point, corner.point);
    if (reached.expanded || total >= reached.length) return;
    reached = {total, from, corner, false};
    tasks_.push({total + length(corner.point, goal_), Task::Kind::corner, corner.id});
}

double TautSearch::min_through(const Cone& cone) const {
    const Viewpoint& from = viewpoints_[cone.view.viewpoint];
    const Portal& portal = cone.portal;
    const bool vertical = portal.side == Side::east || portal.side == Side::west;
    const double line = vertical ? portal.right.x : portal.right.y;
    const double end = vertical ? portal.right.y : portal.right.x;
    const double other_end = vertical ? portal.left.y : portal.left.x;
    const double low = std::min(end, other_end);
    const double high = std::max(end, other_end);
    const double right = std::clamp(crossing(cone.view.right, vertical, line), low, high);
    const double left = std::clamp(crossing(cone.view.left, vertical, line), low, high);
    // A goal on the near side of the portal's line is as far away as its mirror image.
    Point goal = goal_;
    double& goal_across = vertical ? goal.x : goal.y;
    const double from_across = vertical ? from.point.x : from.point.y;
    if ((goal_across - line) * (from_across - line) > 0) goal_across = 2 * line - goal_across;
    const double straight = crossing({from.point, goal}, vertical, line);
    const double via = std::clamp(straight, std::min(left, right), std::max(left, right));
    const Point point = vertical ? Point{line, via} : Point{via, line};
    return from.length + length(from.point, point) + length(point, goal);
}

}  // namespace

double taut_length(CellGraph& graph, const Point& start, const Point& goal, std::size_t effort) {
    return TautSearch(graph, start, goal).run(effort);
}

std::vector<Point> taut_path(CellGraph& graph, const Point& start, const Point& goal,
                             std::size_t effort) {
    TautSearch search(graph, start, goal);
    search.run(effort);
    return search.path();
}

}  // namespace asv::geometry::detail
