#include <algorithm>
#include <map>

#include "core/certificate_check/claims.hpp"
#include "core/certificate_check/facing.hpp"
#include "core/certificate_check/plane.hpp"
#include "core/certificate_check/seam.hpp"
#include "core/certificate_check/strip_area.hpp"

namespace asv::core::certificate_check {

namespace {

std::string numbered(const char* what, std::size_t index) {
    return std::string(what) + " " + std::to_string(index + 1);
}

/// Are the obstacles of a list there, each once, in ascending order, and not too many?
bool check_list(const std::vector<std::size_t>& obstacles, const Problem& problem, Claims& claims) {
    std::string fault;
    if (obstacles.size() > most_certified_obstacles)
        fault = "more than " + std::to_string(most_certified_obstacles) + " are not checked";
    for (std::size_t i = 0; i < obstacles.size() && fault.empty(); ++i) {
        const std::string name = numbered("obstacle", obstacles[i]);
        if (obstacles[i] >= problem.obstacles.size()) fault = "there is no " + name;
        if (i > 0 && obstacles[i] <= obstacles[i - 1])
            fault = name + " stands behind " + numbered("obstacle", obstacles[i - 1]);
    }
    const std::string count = std::to_string(obstacles.size());
    claims.add("list of obstacles", fault.empty(),
               fault.empty() ? count + " of " + std::to_string(problem.obstacles.size()) : fault);
    return fault.empty();
}

/// The obstacles of a list, shrunk; those that vanish are left out.
std::vector<Rectangle> walls_of(const std::vector<std::size_t>& obstacles, const Problem& problem,
                                const Number& shrink) {
    std::vector<Rectangle> walls;
    for (const std::size_t i : obstacles) {
        const Box& box = problem.obstacles[i];
        const Rectangle wall{exact(box.low.x) + shrink, exact(box.high.x) - shrink,
                             exact(box.low.y) + shrink, exact(box.high.y) - shrink};
        if (wall.left <= wall.right && wall.bottom <= wall.top) walls.push_back(wall);
    }
    return walls;
}

std::optional<Rectangle> bounds_of(const Problem& problem, const Limits& limits) {
    if (!problem.requirements.bounded()) return std::nullopt;
    const Box& box = problem.requirements.bounds;
    const Number& e = limits.tolerance;
    return Rectangle{exact(box.low.x) - e, exact(box.high.x) + e, exact(box.low.y) - e,
                     exact(box.high.y) + e};
}

void check_separation(const std::string& who, const std::vector<Rectangle>& walls,
                      const std::optional<Rectangle>& bounds, const Place& start, const Place& goal,
                      Claims& claims) {
    const Connection found = connection(walls, bounds, start, goal);
    const char* detail = found == Connection::separated   ? "no way from start to goal"
                         : found == Connection::connected ? "the walls leave a way"
                                                          : "start or goal is in a wall";
    claims.add(who, found == Connection::separated, detail);
}

Place place_of(const Point& point) {
    return {exact(point.x), exact(point.y)};
}

/// The middle of the chain's arc: an ASV, or the middle of a broom.
Place middle_of(const std::vector<Point>& state) {
    const Place a = place_of(state[(state.size() - 1) / 2]), b = place_of(state[state.size() / 2]);
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// Checks what a certificate says of its corridors.
class CorridorClaims {
  public:
    CorridorClaims(const Problem& problem, const Limits& limits, Claims& claims)
        : problem_(problem), limits_(limits), claims_(claims) {}

    /// The line that the middle of the chain never meets, where the corridor is too low.
    std::optional<Rectangle> check(const ClosedCorridor& corridor, const std::string& name) {
        const Passage passage = passage_between(corridor.between, problem_, limits_);
        if (passage.fault) {
            claims_.add(name, false, *passage.fault);
            return std::nullopt;
        }
        // In one of two states the middle of the chain is no farther than half a step from the
        // cross-section that it passes, and all of the chain no farther than half its length from
        // its middle: between the two walls, of which it would leave the passage at an end alone.
        const Number mouth = limits_.tolerance + limits_.chain / 2 + limits_.step / 2;
        const Number from = passage.from + mouth, to = passage.to - mouth;
        claims_.add_number(name + ", from", corridor.from, from);
        claims_.add_number(name + ", to", corridor.to, to);
        claims_.add_number(name + ", height", corridor.height, passage.gap);
        const Number height = passage.gap + 2 * limits_.tolerance;
        check_area(corridor.greatest_area, area_at(height, rows_of_statements), name + ", area");
        const bool closed = from <= to && is_too_low(height);
        const char* what = closed ? ": too low" : from > to ? ": too short" : ": not too low";
        claims_.add(name, closed, describe(corridor.between) + what);
        if (!closed) return std::nullopt;
        return passage.cross_section((from + to) / 2);
    }

  private:
    void check_area(double stated, const Number& found, const std::string& claim) {
        // Bounds by as many rows differ by less than that share, though they are divided otherwise.
        constexpr double slack = 1e-6;
        const bool same = abs(exact(stated) - found) <= found * exact(slack);
        const std::string text = text_of(found) + " at most";
        claims_.add(claim, same, same ? text : text_of(exact(stated)) + " is stated, " + text);
    }

    Number area_at(const Number& height, std::size_t rows) {
        const auto [known, is_new] = areas_.try_emplace({height, rows});
        if (is_new)
            known->second = strip_area_at_most(limits_.asv_count, limits_.broom, height, rows);
        return known->second;
    }

    /// With more rows where it is so near that they may decide.
    bool is_too_low(const Number& height) {
        constexpr std::size_t most_rows = 2 * rows_of_statements;
        constexpr double near = 1.01;
        const Number area = area_at(height, rows_of_statements);
        if (area < limits_.required_area) return true;
        return area < limits_.required_area * exact(near) &&
               area_at(height, most_rows) < limits_.required_area;
    }

    const Problem& problem_;
    const Limits& limits_;
    Claims& claims_;
    std::map<std::pair<Number, std::size_t>, Number> areas_;  ///< by height and rows
};

}  // namespace

void check(const SeparationProof& proof, const Problem& problem, Claims& claims) {
    const bool collides = problem.body_kind() == BodyKind::point || problem.asv_count() > 1;
    if (problem.body_kind() == BodyKind::arm || !collides)
        return claims.add("body", false, "nothing keeps its ASVs out of obstacles");
    const Limits limits = limits_of(problem);
    claims.add_number("shrink", proof.shrink, limits.shrink);
    const bool listed = check_list(proof.obstacles, problem, claims);
    if (proof.asv >= problem.asv_count())
        return claims.add("separation", false, "there is no " + numbered("ASV", proof.asv));
    if (!listed) return;
    std::vector<Rectangle> walls = walls_of(proof.obstacles, problem, limits.shrink);
    for (std::size_t i = 0; i < proof.seams.size(); ++i) {
        const auto closed =
            check_seam(proof.seams[i], numbered("seam", i), proof.asv, problem, limits, claims);
        if (closed) walls.push_back(*closed);
    }
    check_separation("separation of " + numbered("ASV", proof.asv), walls,
                     bounds_of(problem, limits), place_of(problem.start[proof.asv]),
                     place_of(problem.goal[proof.asv]), claims);
}

void check(const CorridorProof& proof, const Problem& problem, Claims& claims) {
    if (problem.body_kind() != BodyKind::chain || problem.asv_count() < 3)
        return claims.add("body", false, "only chains of three ASVs or more can be too high");
    const Limits limits = limits_of(problem);
    claims.add_number("shrink", proof.shrink, limits.shrink);
    claims.add_number("required area", proof.required_area, limits.required_area);
    if (!check_list(proof.obstacles, problem, claims)) return;
    std::vector<Rectangle> walls = walls_of(proof.obstacles, problem, limits.shrink);
    CorridorClaims corridors(problem, limits, claims);
    for (std::size_t i = 0; i < proof.corridors.size(); ++i) {
        const auto closed = corridors.check(proof.corridors[i], numbered("corridor", i));
        if (closed) walls.push_back(*closed);
    }
    check_separation("separation of the middle", walls, bounds_of(problem, limits),
                     middle_of(problem.start), middle_of(problem.goal), claims);
}

}  // namespace asv::core::certificate_check
