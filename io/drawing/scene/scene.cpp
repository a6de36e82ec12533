#include "io/drawing/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/model/cost.hpp"
#include "core/model/planning_window.hpp"
#include "io/drawing/scene/simplified_line.hpp"

namespace asv::io {

namespace {

using geometry::Point;
using geometry::Segment;

/// In shares of the field's longer side: a ninth of a pixel in the largest picture.
constexpr double simplification = 1.0 / 16000;

/// From ghost to ghost the chain moves about this share of the field's longer side, and more for
/// long chains, which would otherwise hide each other; there are never more than one can tell
/// apart.
constexpr double ghost_spacing = 0.035;
constexpr double ghost_spacing_per_asv = 0.005;
constexpr std::size_t max_ghosts = 36;

/// A state belongs to the tight stretch when its clearance is at most so many brooms, or so many
/// times the least. Improved paths touch every corner on their way, so that the least alone would
/// say little about where it is tight.
constexpr double tight_brooms = 0.1;
constexpr double tight_factor = 2;

/// Links of the tight stretch that end nearer to each other, in shares of the field's longer side,
/// would be painted on top of each other.
constexpr double link_spacing = 0.002;

double longer_side(const geometry::Box& box) {
    return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

/// Adds the lines of one exhibit to a scene.
class Composer {
  public:
    explicit Composer(const Exhibit& exhibit) : exhibit_(exhibit) {
        scene.field = core::planning_window(exhibit.problem);
        scene.obstacles = exhibit.problem.obstacles;
        scene.body = exhibit.problem.body_kind();
    }

    void add_ways() {
        const std::vector<std::size_t> stops = ghost_states();
        scene.ghosts = stops.size() - 2;
        for (std::size_t asv = 0; asv < exhibit_.problem.asv_count(); ++asv) {
            // Search trees are shown through one point: its path is the one that came of them.
            if (exhibit_.trees && asv != point_of_trees()) continue;
            for (std::size_t k = 0; k + 1 < stops.size(); ++k) add_way(asv, stops[k], stops[k + 1]);
        }
        for (std::size_t k = 1; k + 1 < stops.size(); ++k) {
            const auto state = exhibit_.solution->path.state(stops[k]);
            add_chain(state, stops[k], progress(stops[k]), Role::ghost, Role::ghost_closing);
        }
    }

    void add_ends() {
        add_chain(exhibit_.problem.start, 0, 0, Role::start, Role::start_closing);
        const std::size_t last = exhibit_.measures.empty() ? 0 : exhibit_.measures.size() - 1;
        add_chain(exhibit_.problem.goal, last, 1, Role::goal, Role::goal_closing);
    }

    void add_least() {
        const std::size_t tightest = *exhibit_.tightest_state;
        SceneLeast least;
        least.state = tightest;
        least.clearance = exhibit_.measures[tightest].clearance->distance;
        least.link = link(tightest);
        const double limit = std::max(tight_brooms * exhibit_.problem.requirements.broom_length,
                                      tight_factor * least.clearance);
        const auto tight = [&](std::size_t i) {
            return exhibit_.measures[i].clearance->distance <= limit;
        };
        least.first_state = least.last_state = tightest;
        while (least.first_state > 0 && tight(least.first_state - 1)) --least.first_state;
        while (least.last_state + 1 < exhibit_.measures.size() && tight(least.last_state + 1)) {
            ++least.last_state;
        }
        const double apart = link_spacing * longer_side(scene.field);
        for (std::size_t i = least.first_state; i <= least.last_state; ++i) {
            const Segment here = link(i);
            const bool seen =
                !least.links.empty() && std::hypot(here.b.x - least.links.back().b.x,
                                                   here.b.y - least.links.back().b.y) < apart;
            if (!seen) least.links.push_back(here);
        }
        scene.least = std::move(least);
    }

    /// The worst of each check.
    void add_violations() {
        for (const core::CheckResult& check : exhibit_.report.checks) {
            if (check.ok() || !check.worst || check.check == core::Check::cost) continue;
            const core::Offender& offender = *check.worst;
            const auto state = state_of(offender);
            // Start and goal stand at both ends, whether there is a path or not.
            const bool on_path = exhibit_.solution.has_value();
            const std::size_t index = on_path ? offender.state : 0;
            const double at = on_path ? progress(index) : static_cast<double>(offender.state);
            scene.violations.push_back({index, check.check, place(offender)});
            scene.lines.push_back({Role::violation, index, at, {state.begin(), state.end()}});
        }
    }

    void add_trees() {
        const SearchTrees& trees = *exhibit_.trees;
        for (const SearchTree& tree : trees.trees) scene.trees.push_back(shown(tree));
        for (const auto& [from, to] : trees.edges) {
            scene.trees[0].edges.push_back(
                {trees.trees[0].points[from], trees.trees[0].points[to]});
        }
    }

    Scene scene;

  private:
    Segment link(std::size_t state) const {
        const Clearance& clearance = *exhibit_.measures[state].clearance;
        return shortest_link(broom_of(exhibit_.solution->path.state(state), clearance.broom),
                             exhibit_.problem.obstacles[clearance.obstacle]);
    }

    double progress(std::size_t state) const {
        const double total = exhibit_.measures.back().cost;
        return total == 0 ? 0 : exhibit_.measures[state].cost / total;
    }

    /// ASV 1, or the tip of an arm.
    std::size_t point_of_trees() const {
        return exhibit_.problem.arm() ? exhibit_.problem.asv_count() - 1 : 0;
    }

    /// By all points together; an arm's cost is no distance.
    double distance_moved() const {
        if (!exhibit_.problem.arm()) return exhibit_.measures.back().cost;
        return core::cost(exhibit_.solution->path);
    }

    /// First and last state, and those between that are even in cost.
    std::vector<std::size_t> ghost_states() const {
        const auto& measures = exhibit_.measures;
        const double each = distance_moved() / static_cast<double>(exhibit_.problem.asv_count());
        const double spacing =
            ghost_spacing +
            ghost_spacing_per_asv * static_cast<double>(exhibit_.problem.asv_count());
        const double parts = std::round(each / (spacing * longer_side(scene.field)));
        const auto count =
            static_cast<std::size_t>(std::clamp(parts, 1.0, static_cast<double>(max_ghosts + 1)));
        std::vector<std::size_t> states{0};
        for (std::size_t k = 1; k < count; ++k) {
            const double cost =
                measures.back().cost * static_cast<double>(k) / static_cast<double>(count);
            const auto at = std::lower_bound(measures.begin(), measures.end(), cost,
                                             [](const StateMeasures& measures_here, double c) {
                                                 return measures_here.cost < c;
                                             });
            const auto state = static_cast<std::size_t>(at - measures.begin());
            if (state > states.back() && state + 1 < measures.size()) states.push_back(state);
        }
        states.push_back(measures.size() - 1);
        return states;
    }

    void add_way(std::size_t asv, std::size_t first, std::size_t last) {
        std::vector<Point> points;
        for (std::size_t i = first; i <= last; ++i) {
            points.push_back(exhibit_.solution->path.state(i)[asv]);
        }
        scene.lines.push_back({Role::path, asv, (progress(first) + progress(last)) / 2,
                               simplified(points, simplification * longer_side(scene.field))});
    }

    void add_chain(std::span<const Point> state, std::size_t index, double progress, Role chain,
                   Role closing) {
        if (state.size() > 2 && !exhibit_.problem.arm()) {
            scene.lines.push_back({closing, index, progress, {state.back(), state.front()}});
        }
        scene.lines.push_back({chain, index, progress, {state.begin(), state.end()}});
    }

    /// Of the path; without one, state 0 is the start and state 1 the goal.
    std::span<const Point> state_of(const core::Offender& offender) const {
        if (exhibit_.solution) return exhibit_.solution->path.state(offender.state);
        return offender.state == 0 ? exhibit_.problem.start : exhibit_.problem.goal;
    }

    /// Where the broom meets the obstacle, the middle of the broom, or the ASV to blame; else
    /// ASV 1.
    Point place(const core::Offender& offender) const {
        const auto state = state_of(offender);
        if (!offender.broom) return state[offender.asv.value_or(0)];
        const Segment broom = broom_of(state, *offender.broom);
        if (offender.obstacle) {
            return shortest_link(broom, exhibit_.problem.obstacles[*offender.obstacle]).a;
        }
        return {(broom.a.x + broom.b.x) / 2, (broom.a.y + broom.b.y) / 2};
    }

    static SceneTree shown(const SearchTree& tree) {
        SceneTree result;
        result.kind = tree.root == "start"  ? SceneTree::Kind::start
                      : tree.root == "goal" ? SceneTree::Kind::goal
                                            : SceneTree::Kind::roadmap;
        for (std::size_t i = 0; i < tree.points.size(); ++i) {
            if (tree.parents[i] >= 0) {
                const auto parent = static_cast<std::size_t>(tree.parents[i]);
                result.edges.push_back({tree.points[parent], tree.points[i]});
            } else if (result.kind != SceneTree::Kind::roadmap) {
                result.roots.push_back(tree.points[i]);
            }
        }
        if (result.kind == SceneTree::Kind::roadmap) result.nodes = tree.points;
        return result;
    }

    const Exhibit& exhibit_;
};

}  // namespace

Scene make_scene(const Exhibit& exhibit) {
    Composer composer(exhibit);
    if (exhibit.trees) composer.add_trees();
    if (exhibit.solution) composer.add_ways();
    composer.add_ends();
    if (exhibit.tightest_state) composer.add_least();
    composer.add_violations();
    composer.scene.closed = exhibit.feasibility.closed;
    composer.scene.meaning_of_closed =
        exhibit.feasibility.cause == core::Infeasibility::no_room_to_turn
            ? "no room to turn, though the chain would have to here"
            : "no room: the middle of the chain cannot get here";
    std::stable_sort(composer.scene.lines.begin(), composer.scene.lines.end(),
                     [](const SceneLine& a, const SceneLine& b) { return a.role < b.role; });
    return std::move(composer.scene);
}

}  // namespace asv::io
