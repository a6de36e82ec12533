#include <algorithm>
#include <cmath>
#include <string>

#include "core/generate/carve.hpp"
#include "core/generate/families.hpp"
#include "core/generate/option_check.hpp"
#include "core/shapes/flat_chain.hpp"

namespace asv::core {

using geometry::grown;

namespace {

/// Numbers in [low, high), each at least `apart` away from the one before.
std::vector<double> draw_levels(std::size_t count, double low, double high, double apart,
                                Rng& rng) {
    if (!(apart <= (high - low) / 2))
        throw std::invalid_argument("no room for levels " + std::to_string(apart) + " apart");
    std::vector<double> levels;
    while (levels.size() < count) {
        const double level = rng.uniform(low, high);
        if (levels.empty() || std::abs(level - levels.back()) >= apart) levels.push_back(level);
    }
    return levels;
}

Box around(const Point& a, const Point& b, double half_width) {
    return grown(
        {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}},
        half_width);
}

Box upright_strip(double low_x, double high_x) {
    return {{low_x, 0}, {high_x, 1}};
}

void append(std::vector<Box>& boxes, const std::vector<Box>& more) {
    boxes.insert(boxes.end(), more.begin(), more.end());
}

void require_fits(const char* what, double room, double least) {
    if (room < least) throw std::invalid_argument(std::string(what) + " leave no room for a way");
}

}  // namespace

double PassageHeight::value(std::size_t asv_count, const Requirements& requirements) const {
    if (absolute) {
        require_range("height", *absolute, 0.001, 0.5);
        return *absolute;
    }
    require_range("height-factor", factor, 0.05, 50.0);
    const double height = factor * min_flat_height(measured_asvs(asv_count), requirements);
    require_derived(asv_count, "a corridor", "high", height, 0.001, 0.5);
    return height;
}

Problem corridor(const CorridorOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const double half_height =
        options.height.value(options.chain.asv_count, problem.requirements) / 2;
    const std::size_t n = measured_asvs(options.chain.asv_count);
    const double chain_length = problem.requirements.broom_length * static_cast<double>(n - 1);
    const double hooked =
        std::clamp(1 - 2.15 * round_diameter(n, problem.requirements), 0.1, 1.0 / 3.0);
    const double length =
        options.length.value_or(1.05 * chain_length <= 0.5 ? 1.05 * chain_length : hooked);
    require_range("length", length, 0.01, 0.8);
    if (options.level) require_range("level", *options.level, 0.1, 0.9);
    const double level = options.level.value_or(rng.uniform(0.3, 0.7));
    const double left = (1 - length) * rng.uniform(0.48, 0.52);
    const double right = left + length;
    const Box passage{{left, level - half_height}, {right, level + half_height}};
    problem.obstacles = carve(upright_strip(left, right), {&passage, 1});
    draw_ends(problem, options.chain, {upright_strip(0, left), upright_strip(right, 1)}, rng);
    return problem;
}

Problem bend(const BendOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const double height = options.height.value(options.chain.asv_count, problem.requirements);
    require_range("bends", options.bends, 1u, 8u);
    require_range("leg", options.leg, 0.02, 0.35);
    require_range("room", options.room, 0.1, 0.4);
    const bool to_the_top = options.bends % 2 == 1;
    const std::size_t uprights = (options.bends + 1) / 2;
    const double left = options.room;
    const double right = to_the_top ? 1 : 1 - options.room;
    const double top = to_the_top ? 1 - options.room : 1;
    const double spacing =
        (right - left) / (static_cast<double>(uprights) + (to_the_top ? 0.5 : 1.0));
    require_fits("bends and height", spacing - height, 0.02);

    const std::vector<double> levels =
        draw_levels(uprights + (to_the_top ? 0 : 1), height / 2 + 0.05, top - height / 2 - 0.05,
                    options.leg, rng);
    std::vector<Box> passages;
    Point at{left - height, levels.front()};
    for (std::size_t i = 0; i < uprights; ++i) {
        const Point corner{left + spacing * static_cast<double>(i + 1), at.y};
        const Point next{corner.x, i + 1 < levels.size() ? levels[i + 1] : top};
        passages.push_back(around(at, corner, height / 2));
        passages.push_back(around(corner, next, height / 2));
        at = next;
    }
    const double wall = 0.02;  // between the first room and the room at the top
    const Box goal_room = to_the_top ? Box{{left + wall, top}, {1, 1}} : upright_strip(right, 1);
    passages.push_back(to_the_top ? goal_room : around(at, {1, at.y}, height / 2));
    problem.obstacles = carve({{left, 0}, {right, 1}}, passages);
    draw_ends(problem, options.chain, {upright_strip(0, left), goal_room}, rng);
    return problem;
}

Problem gauntlet(const GauntletOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const std::size_t n = measured_asvs(options.chain.asv_count);
    const double height = options.height.value(n, problem.requirements);
    require_range("walls", options.walls, 1u, 6u);
    require_range("thickness", options.thickness, 0.005, 0.5);
    require_range("least-offset", options.min_offset, 0.0, 0.35);
    const auto walls = static_cast<double>(options.walls);
    const double room = options.room.value_or(
        std::min(std::clamp(1.25 * round_diameter(n, problem.requirements), 0.2, 0.34),
                 (1 - walls * options.thickness - (walls - 1) * 0.1) / 2));
    require_range("walls, thickness and room", room, 0.02, 0.48);
    const double between = options.walls == 1
                               ? 1 - 2 * room
                               : (1 - 2 * room - walls * options.thickness) / (walls - 1);
    require_fits("walls, thickness and room", between,
                 options.walls == 1 ? options.thickness : 0.02);

    const auto levels = draw_levels(options.walls, 0.1, 0.9, options.min_offset, rng);
    double left = options.walls == 1 ? (1 - options.thickness) / 2 : room;
    const double start_right = left;
    for (const double level : levels) {
        const double right = left + options.thickness;
        const Box passage{{left, level - height / 2}, {right, level + height / 2}};
        append(problem.obstacles, carve(upright_strip(left, right), {&passage, 1}));
        left = right + between;
    }
    draw_ends(problem, options.chain,
              {upright_strip(0, start_right), upright_strip(left - between, 1)}, rng);
    return problem;
}

Problem rooms(const RoomsOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const double height = options.height.value(options.chain.asv_count, problem.requirements);
    require_range("rooms", options.rooms, 2u, 6u);
    require_range("doors", options.doors, 1u, 4u);
    require_range("thickness", options.thickness, 0.005, 0.3);
    require_range("shelves", options.shelves, 0u, 50u);
    require_range("shelf-gap", options.shelf_gap, 0.0, 0.3);
    const auto room_count = static_cast<double>(options.rooms);
    const double width = (1 - (room_count - 1) * options.thickness) / room_count;
    const double slot = 1 / static_cast<double>(options.doors);
    require_fits("rooms and thickness", width, 0.05);
    require_fits("doors and height", slot - height, 0.05);

    std::vector<Box> doors;
    for (double left = width; left + width < 1; left += width + options.thickness) {
        const double right = left + options.thickness;
        std::vector<Box> passages;
        for (std::size_t i = 0; i < options.doors; ++i) {
            const double low =
                slot * static_cast<double>(i) + rng.uniform(0.02, slot - height - 0.02);
            passages.push_back({{left, low}, {right, low + height}});
        }
        append(problem.obstacles, carve(upright_strip(left, right), passages));
        append(doors, passages);
    }
    for (std::size_t placed = 0, tries = 0; placed < options.shelves; ++tries) {
        if (tries > 10'000) throw NoRoom("the doors leave no room for the shelves");
        const Point size{rng.uniform(0.04, 0.12), rng.uniform(0.04, 0.12)};
        const Point low{rng.uniform(0, 1 - size.x), rng.uniform(0, 1 - size.y)};
        const Box shelf{low, {low.x + size.x, low.y + size.y}};
        const Box kept_clear = grown(shelf, options.shelf_gap);
        if (std::any_of(doors.begin(), doors.end(), [&](const Box& door) {
                return door.low.x < kept_clear.high.x && door.high.x > kept_clear.low.x &&
                       door.low.y < kept_clear.high.y && door.high.y > kept_clear.low.y;
            }))
            continue;
        problem.obstacles.push_back(shelf);
        ++placed;
    }
    draw_ends(problem, options.chain, {upright_strip(0, width), upright_strip(1 - width, 1)}, rng);
    return problem;
}

}  // namespace asv::core
