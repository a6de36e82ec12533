#include "io/drawing/scene/scene_outline.hpp"

#include <sstream>

namespace asv::io {

namespace {

std::string text(const geometry::Point& point) {
    return fixed(point.x, 4) + "," + fixed(point.y, 4);
}

}  // namespace

std::string_view name(Role role) {
    switch (role) {
        case Role::path:
            return "path";
        case Role::ghost_closing:
            return "ghost closing";
        case Role::ghost:
            return "ghost";
        case Role::start_closing:
            return "start closing";
        case Role::goal_closing:
            return "goal closing";
        case Role::start:
            return "start";
        case Role::goal:
            return "goal";
        case Role::violation:
            return "violation";
    }
    return "";
}

std::string outline(const Scene& scene) {
    std::ostringstream out;
    out << "field " << text(scene.field.low) << " " << text(scene.field.high) << "\n";
    for (const auto& box : scene.obstacles) {
        out << "obstacle " << text(box.low) << " " << text(box.high) << "\n";
    }
    for (const SceneTree& tree : scene.trees) {
        out << "tree " << static_cast<int>(tree.kind) << " edges " << tree.edges.size() << " roots "
            << tree.roots.size() << " nodes " << tree.nodes.size() << "\n";
    }
    for (const SceneLine& line : scene.lines) {
        out << name(line.role) << " " << line.index << " at " << fixed(line.progress, 2);
        for (const geometry::Point& point : line.points) out << " " << text(point);
        out << "\n";
    }
    if (scene.least) {
        out << "least clearance " << fixed(scene.least->clearance, 4) << " state "
            << scene.least->state << " " << text(scene.least->link.a) << " "
            << text(scene.least->link.b) << " tight from " << scene.least->first_state << " to "
            << scene.least->last_state << "\n";
    }
    for (const SceneViolation& violation : scene.violations) {
        out << "violated " << core::name(violation.check) << " state " << violation.state << " "
            << text(violation.at) << "\n";
    }
    return out.str();
}

}  // namespace asv::io
