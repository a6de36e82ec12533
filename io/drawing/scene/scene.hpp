#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/drawing/exhibit.hpp"

namespace asv::io {

/// What a line of a picture stands for. Lines are painted in this order, later ones on top.
enum class Role { path, ghost_closing, ghost, start_closing, goal_closing, start, goal, violation };

/// One line in workspace units.
struct SceneLine {
    Role role = Role::path;
    std::size_t index = 0;  ///< of the ASV for a path, of the state for all others; 0-based
    double progress = 0;    ///< how far along the way, in cost: 0 at the start, 1 at the goal
    std::vector<geometry::Point> points;
};

/// The edges of one search tree, or of a roadmap, in workspace units.
struct SceneTree {
    enum class Kind { start, goal, roadmap };
    Kind kind = Kind::start;
    std::vector<geometry::Segment> edges;
    std::vector<geometry::Point> roots;
    std::vector<geometry::Point> nodes;  ///< of a roadmap alone
};

/// Where the clearance is least, and the tight stretch of the way around it: the shortest links
/// from the chain to the obstacles in all states, one after the other, before and after, whose
/// clearance is at most a tenth of a broom, or twice the least where that is more. Where the chain
/// slides through a corridor, the links end along its walls.
struct SceneLeast {
    std::size_t state = 0;
    double clearance = 0;
    geometry::Segment link;       ///< from the broom to the obstacle; a point where they meet
    std::size_t first_state = 0;  ///< of the tight stretch
    std::size_t last_state = 0;   ///< of the tight stretch
    std::vector<geometry::Segment> links;  ///< of the tight stretch, those a picture can tell apart
};

/// A violated requirement that has a place.
struct SceneViolation {
    std::size_t state = 0;
    core::Check check = core::Check::ends;
    geometry::Point at;
};

/// Everything in a picture, before anything about colours, pixels and pages is decided.
struct Scene {
    geometry::Box field;
    std::vector<geometry::Box> obstacles;
    std::vector<SceneTree> trees;
    std::vector<SceneLine> lines;  ///< in the order of painting
    std::optional<SceneLeast> least;
    std::vector<SceneViolation> violations;
    std::vector<geometry::Box> closed;  ///< why there is no path
    std::string meaning_of_closed;      ///< for the legend
    std::size_t ghosts = 0;
    core::BodyKind body = core::BodyKind::chain;
};

/// The picture of an exhibit. Ghosts of the chain stand evenly in cost, that is in the distance
/// moved by all ASVs, and their number follows the length of the way. Lines are simplified by far
/// less than a picture can show; a path of an ASV is cut at every ghost. With search trees, only
/// ASV 1 has its path shown, since the trees are drawn through it.
Scene make_scene(const Exhibit& exhibit);

}  // namespace asv::io
