#include "asv/geometry/free_space/taut_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "asv/geometry/orientation.hpp"

namespace asv::geometry::detail {

namespace {

double length(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// A ray that bounds what is seen: its line runs from a through b.
struct Ray {
    Point a;
    Point b;
};

int side_of(const Ray& ray, const Point& point) {
    return orientation(ray.a, ray.b, point);
}

/// A point from which the search looks around: the start or a corner that has been reached.
struct Viewpoint {
    Point point;
    double length = 0;  ///< of the way from the start
};

/// What a viewpoint sees through a portal that it has reached.
struct Cone {
    std::uint32_t viewpoint = 0;
    Portal portal;
    Ray right;
    Ray left;
};

/// What is left to do, by the least length of a path that it can lead to.
struct Task {
    enum class Kind : std::uint8_t { goal, corner, cone };
    double least = 0;
    Kind kind = Kind::goal;
    std::uint32_t index = 0;  ///< of the corner or the cone
    friend bool operator<(const Task& a, const Task& b) { return a.least > b.least; }
};

/// Where the ray meets the portal's line: the coordinate along that line.
double crossing(const Ray& ray, bool vertical, double at) {
    const double dx = ray.b.x - ray.a.x;
    const double dy = ray.b.y - ray.a.y;
    return vertical ? ray.a.y + dy * ((at - ray.a.x) / dx) : ray.a.x + dx * ((at - ray.a.y) / dy);
}

class TautSearch {
  public:
    TautSearch(CellGraph& graph, const Point& start, const Point& goal)
        : graph_(graph), start_(start), goal_(goal), goal_cells_(graph.cells_at(goal)) {}

    double run() {
        views_.push_back({start_, 0});
        look_around(0, nullptr, nullptr);
        while (!tasks_.empty()) {
            const Task task = tasks_.top();
            tasks_.pop();
            if (task.kind == Task::Kind::goal) return task.least;
            if (task.kind == Task::Kind::cone) {
                enter(take(task.index), task.least);
            } else {
                expand(task.index);
            }
        }
        return std::numeric_limits<double>::infinity();
    }

  private:
    struct Reached {
        double length = std::numeric_limits<double>::infinity();
        std::uint32_t from = 0;  ///< the viewpoint
        bool closed = false;
    };

    void expand(CellGraph::CornerId id);
    void look_around(std::uint32_t view, const Ray* right, const Ray* left);
    void enter(const Cone& first, double least);
    void pass(const Cone& seen, double least);
    void meet_corner(std::uint32_t view, CellGraph::CornerId id);
    void meet_contents(std::uint32_t view, CellTree::Id cell, const Ray* right, const Ray* left);
    double least_through(const Cone& cone) const;
    std::uint32_t keep(const Cone& cone);
    Cone take(std::uint32_t index);

    CellGraph& graph_;
    Point start_;
    Point goal_;
    std::vector<CellTree::Id> goal_cells_;
    std::vector<Viewpoint> views_;
    std::vector<Reached> reached_;
    std::vector<Cone> cones_;
    std::vector<std::uint32_t> unused_cones_;
    std::vector<Cone> at_hand_;
    std::priority_queue<Task> tasks_;
};

std::uint32_t TautSearch::keep(const Cone& cone) {
    if (unused_cones_.empty()) {
        cones_.push_back(cone);
        return static_cast<std::uint32_t>(cones_.size() - 1);
    }
    const std::uint32_t index = unused_cones_.back();
    unused_cones_.pop_back();
    cones_[index] = cone;
    return index;
}

Cone TautSearch::take(std::uint32_t index) {
    unused_cones_.push_back(index);
    return cones_[index];
}

void TautSearch::expand(CellGraph::CornerId id) {
    if (reached_[id].closed) return;
    reached_[id].closed = true;
    const Corner corner = graph_.corner(id);
    const Point& at = corner.point;
    const Point from = views_[reached_[id].from].point;
    const auto view = static_cast<std::uint32_t>(views_.size());
    views_.push_back({at, reached_[id].length});
    // A taut path goes on between straight ahead and along the wall that it came to.
    const bool from_x_side = (from.x - at.x) * corner.obstacle_x > 0;
    const Point along_wall =
        from_x_side ? Point{at.x, at.y + corner.obstacle_y} : Point{at.x + corner.obstacle_x, at.y};
    const Ray ahead{from, at};
    const Ray wall{at, along_wall};
    if (side_of(ahead, along_wall) > 0) {
        look_around(view, &ahead, &wall);
    } else {
        look_around(view, &wall, &ahead);
    }
}

void TautSearch::look_around(std::uint32_t view, const Ray* right, const Ray* left) {
    const Point at = views_[view].point;
    for (const CellTree::Id cell : graph_.cells_at(at)) {
        meet_contents(view, cell, right, left);
        for (const Portal& portal : graph_.portals(cell)) {
            if (orientation(at, portal.right, portal.left) <= 0) continue;
            Cone cone{view, portal, {at, portal.right}, {at, portal.left}};
            if (right != nullptr && side_of(*right, portal.right) < 0) cone.right = *right;
            if (left != nullptr && side_of(*left, portal.left) > 0) cone.left = *left;
            if (right != nullptr && side_of(*right, portal.left) <= 0) continue;
            if (left != nullptr && side_of(*left, portal.right) >= 0) continue;
            tasks_.push({least_through(cone), Task::Kind::cone, keep(cone)});
        }
    }
}

void TautSearch::meet_contents(std::uint32_t view, CellTree::Id cell, const Ray* right,
                               const Ray* left) {
    const auto in_sight = [&](const Point& point) {
        return (right == nullptr || side_of(*right, point) >= 0) &&
               (left == nullptr || side_of(*left, point) <= 0);
    };
    for (const CellGraph::CornerId id : graph_.corners(cell)) {
        if (in_sight(graph_.corner(id).point)) meet_corner(view, id);
    }
    if (std::find(goal_cells_.begin(), goal_cells_.end(), cell) != goal_cells_.end() &&
        in_sight(goal_)) {
        const double total = views_[view].length + length(views_[view].point, goal_);
        tasks_.push({total, Task::Kind::goal, 0});
    }
}

void TautSearch::meet_corner(std::uint32_t view, CellGraph::CornerId id) {
    if (id >= reached_.size())
        reached_.resize(std::max<std::size_t>(graph_.corner_limit(), id + 1));
    if (reached_[id].closed) return;
    const Corner& corner = graph_.corner(id);
    const Point& from = views_[view].point;
    // Only who comes along one wall of the corner's obstacle can bend around it; who comes straight
    // down the second wall bends at its far end.
    const double x = (from.x - corner.point.x) * corner.obstacle_x;
    const double y = (from.y - corner.point.y) * corner.obstacle_y;
    if (!((x > 0 && y <= 0) || (y > 0 && x <= 0))) return;
    const double total = views_[view].length + length(from, corner.point);
    if (total >= reached_[id].length) return;
    reached_[id].length = total;
    reached_[id].from = view;
    tasks_.push({total + length(corner.point, goal_), Task::Kind::corner, id});
}

void TautSearch::enter(const Cone& first, double least) {
    // What costs no more than the task at hand would be next anyway: it need not be queued.
    at_hand_.push_back(first);
    while (!at_hand_.empty()) {
        const Cone cone = at_hand_.back();
        at_hand_.pop_back();
        meet_contents(cone.viewpoint, cone.portal.cell, &cone.right, &cone.left);
        pass(cone, least);
    }
}

void TautSearch::pass(const Cone& seen, double least) {
    const Point at = views_[seen.viewpoint].point;
    const auto entered_from = static_cast<Side>((static_cast<int>(seen.portal.side) + 2) % 4);
    for (const Portal& portal : graph_.portals(seen.portal.cell)) {
        if (portal.side == entered_from) continue;
        if (side_of(seen.right, portal.left) <= 0 || side_of(seen.left, portal.right) >= 0)
            continue;
        if (orientation(at, portal.right, portal.left) <= 0) continue;
        Cone cone{seen.viewpoint, portal, seen.right, seen.left};
        if (side_of(seen.right, portal.right) >= 0) cone.right = {at, portal.right};
        if (side_of(seen.left, portal.left) <= 0) cone.left = {at, portal.left};
        const double through = least_through(cone);
        if (through <= least) {
            at_hand_.push_back(cone);
        } else {
            tasks_.push({through, Task::Kind::cone, keep(cone)});
        }
    }
}

double TautSearch::least_through(const Cone& cone) const {
    const Viewpoint& view = views_[cone.viewpoint];
    const bool vertical = cone.portal.side == Side::east || cone.portal.side == Side::west;
    const double line = vertical ? cone.portal.right.x : cone.portal.right.y;
    const Portal& portal = cone.portal;
    const auto [low, high] = std::minmax(vertical ? portal.right.y : portal.right.x,
                                         vertical ? portal.left.y : portal.left.x);
    const double right = std::clamp(crossing(cone.right, vertical, line), low, high);
    const double left = std::clamp(crossing(cone.left, vertical, line), low, high);
    // A goal on the near side of the portal's line is as far away as its mirror image.
    Point goal = goal_;
    double& goal_across = vertical ? goal.x : goal.y;
    const double from_across = vertical ? view.point.x : view.point.y;
    if ((goal_across - line) * (from_across - line) > 0) goal_across = 2 * line - goal_across;
    const double straight = crossing({view.point, goal}, vertical, line);
    const double via = std::clamp(straight, std::min(left, right), std::max(left, right));
    const Point point = vertical ? Point{line, via} : Point{via, line};
    return view.length + length(view.point, point) + length(point, goal);
}

}  // namespace

double taut_length(CellGraph& graph, const Point& start, const Point& goal) {
    return TautSearch(graph, start, goal).run();
}

}  // namespace asv::geometry::detail
