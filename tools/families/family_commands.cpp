#include "tools/families/family_commands.hpp"

#include <memory>
#include <string>
#include <utility>

#include "tools/families/option_kinds.hpp"

namespace asv::tools {

namespace {

/// Adds --NAME-factor and --NAME, of which one sets how high or wide something is.
/// Size: core::PassageHeight or core::WayWidth.
template <class Size>
void add_size(CLI::App& command, Size& size, const std::string& name, Range of_factor,
              Range of_size, const std::string& meaning) {
    CLI::Option* factor =
        add_number(command, "--" + name + "-factor", size.factor, of_factor, meaning);
    add_number(command, "--" + name, size.absolute, of_size, "The same in workspace units")
        ->excludes(factor);
}

void add_height(CLI::App& command, core::PassageHeight& height) {
    add_size(command, height, "height", {0.05, 50}, {0.001, 0.5},
             "Height of a corridor or door, as a multiple of the least height of a flat chain");
}

void add_way(CLI::App& command, core::WayWidth& way, const std::string& name) {
    add_size(command, way, name, {0.1, 20}, {0.005, 0.9},
             "Width of the " + name + ", as a multiple of the diameter of a round chain");
}

/// Registers a family: add_options(command, options) binds its options.
template <class Options, class AddOptions>
void add_family(CLI::App& app, std::vector<Family>& families, const std::string& name,
                const std::string& description, core::Problem (*draw)(const Options&, core::Rng&),
                AddOptions add_options) {
    CLI::App* command = app.add_subcommand(name, description)->fallthrough();
    command->footer(
        "The options of all families (-n, --seed, -o, --orientation, --solvable, ...): "
        "asv-generate --help");
    const auto options = std::make_shared<Options>();
    add_options(*command, *options);
    families.push_back({command, [options, draw](const core::ChainOptions& chain, core::Rng& rng) {
                            options->chain = chain;
                            return draw(*options, rng);
                        }});
}

void add_corridor_families(CLI::App& app, std::vector<Family>& families) {
    add_family<core::CorridorOptions>(
        app, families, "corridor", "One straight corridor between two blocks", core::corridor,
        [](CLI::App& command, core::CorridorOptions& options) {
            add_height(command, options.height);
            add_number(command, "--length", options.length, {0.01, 0.8},
                       "Of the corridor; default: longer than the chain where there is "
                       "room, else at most 1/3");
            add_number(command, "--level", options.level, {0.1, 0.9},
                       "y of its axis; default: drawn");
        });
    add_family<core::BendOptions>(
        app, families, "bend", "One corridor with right-angled bends", core::bend,
        [](CLI::App& command, core::BendOptions& options) {
            add_height(command, options.height);
            add_count(command, "--bends", options.bends, {1, 8}, "How many");
            add_number(command, "--leg", options.leg, {0.02, 0.35},
                       "Least length of an upright leg");
            add_number(command, "--room", options.room, {0.1, 0.4},
                       "Width of the rooms at both ends");
        });
    add_family<core::GauntletOptions>(
        app, families, "gauntlet", "Walls in a row, each with a corridor of its own",
        core::gauntlet, [](CLI::App& command, core::GauntletOptions& options) {
            add_height(command, options.height);
            add_count(command, "--walls", options.walls, {1, 6}, "How many");
            add_number(command, "--thickness", options.thickness, {0.005, 0.5}, "Of each wall");
            add_number(command, "--least-offset", options.min_offset, {0, 0.35},
                       "Least distance in y between neighbouring corridors");
            add_number(command, "--room", options.room, {0.02, 0.48},
                       "Width of the first and the last room; default: as the chain needs");
        });
    add_family<core::RoomsOptions>(
        app, families, "rooms", "Rooms in a row with doors and shelves", core::rooms,
        [](CLI::App& command, core::RoomsOptions& options) {
            add_height(command, options.height);
            add_count(command, "--rooms", options.rooms, {2, 6}, "How many");
            add_count(command, "--doors", options.doors, {1, 4}, "In each wall");
            add_number(command, "--thickness", options.thickness, {0.005, 0.3}, "Of each wall");
            add_count(command, "--shelves", options.shelves, {0, 50}, "Boxes in the rooms");
            add_number(command, "--shelf-gap", options.shelf_gap, {0, 0.3},
                       "Least distance of shelf and door");
        });
}

void add_maze_families(CLI::App& app, std::vector<Family>& families) {
    add_family<core::MazeOptions>(
        app, families, "maze", "A perfect maze of square cells", core::maze,
        [](CLI::App& command, core::MazeOptions& options) {
            add_way(command, options.way, "way");
            add_number(command, "--wall", options.wall, {0.001, 0.3}, "Least thickness of a wall");
            add_count(command, "--cells", options.cells, {2, 60},
                      "On each side; default: what fits");
        });
    add_family<core::SpiralOptions>(
        app, families, "spiral", "A square spiral", core::spiral,
        [](CLI::App& command, core::SpiralOptions& options) {
            add_way(command, options.way, "way");
            add_number(command, "--wall", options.wall, {0.001, 0.3}, "Thickness of the walls");
            add_count(command, "--legs", options.legs, {2, 200},
                      "Straight parts; default: what fits");
            add_choice<core::SpiralDirection>(command, "--direction", options.direction,
                                              "From the start to the goal",
                                              {{"random", core::SpiralDirection::random},
                                               {"inward", core::SpiralDirection::inward},
                                               {"outward", core::SpiralDirection::outward}});
        });
}

void add_open_families(CLI::App& app, std::vector<Family>& families) {
    add_family<core::CrossingOptions>(
        app, families, "crossing", "A crossing of two wide roads", core::crossing,
        [](CLI::App& command, core::CrossingOptions& options) {
            const std::vector<std::pair<std::string, core::Branch>> branches{
                {"random", core::Branch::random},
                {"east", core::Branch::east},
                {"north", core::Branch::north},
                {"west", core::Branch::west},
                {"south", core::Branch::south}};
            add_way(command, options.road, "road");
            add_number(command, "--offset", options.offset, {0, 0.2},
                       "How far off the middle the roads may be");
            add_choice(command, "--start-arm", options.start_arm, "Where the start is", branches);
            add_choice(command, "--goal-arm", options.goal_arm, "Where the goal is", branches);
        });
    add_family<core::ClutterOptions>(
        app, families, "clutter", "Random boxes", core::clutter,
        [](CLI::App& command, core::ClutterOptions& options) {
            add_count(command, "--obstacles", options.obstacles, {0, 1000000}, "How many");
            add_number(command, "--density", options.density, {0.0001, 0.9}, "Sum of their areas");
            add_number(command, "--side-ratio", options.side_ratio, {1, 20},
                       "Longest side to shortest side");
            add_number(command, "--lane", options.lane, {0, 5},
                       "Width of a lane that stays free, as a multiple of the diameter of "
                       "a round chain, 0 for none; default: only where the boxes are dense");
        });
}

}  // namespace

std::vector<Family> add_families(CLI::App& app) {
    std::vector<Family> families;
    add_corridor_families(app, families);
    add_maze_families(app, families);
    add_open_families(app, families);
    return families;
}

}  // namespace asv::tools
