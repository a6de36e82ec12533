#include "tools/generate/family_commands.hpp"

#include <memory>
#include <string>
#include <utility>

#include "tools/generate/option_kinds.hpp"

namespace asv::tools {

namespace {

/// Adds --NAME-factor and --NAME, of which one sets how high or wide something is.
/// Size: core::PassageHeight or core::WayWidth.
template <class Size>
void add_size(CLI::App& command, Size& size, const std::string& name, const std::string& meaning) {
    CLI::Option* factor =
        command.add_option("--" + name + "-factor", size.factor, meaning)->capture_default_str();
    command.add_option("--" + name, size.absolute, "The same in workspace units")->excludes(factor);
}

void add_height(CLI::App& command, core::PassageHeight& height) {
    add_size(command, height, "height",
             "Height of a corridor or door, as a multiple of the least height of a flat chain");
}

void add_way(CLI::App& command, core::WayWidth& way, const std::string& name) {
    add_size(command, way, name,
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
            command.add_option("--length", options.length,
                               "Of the corridor; default: longer than the chain where there is "
                               "room, else at most 1/3");
            command.add_option("--level", options.level, "y of its axis; default: drawn");
        });
    add_family<core::BendOptions>(
        app, families, "bend", "One corridor with right-angled bends", core::bend,
        [](CLI::App& command, core::BendOptions& options) {
            add_height(command, options.height);
            add_count(command, "--bends", options.bends, "How many");
            command.add_option("--leg", options.leg, "Least length of an upright leg")
                ->capture_default_str();
            command.add_option("--room", options.room, "Width of the rooms at both ends")
                ->capture_default_str();
        });
    add_family<core::GauntletOptions>(
        app, families, "gauntlet", "Walls in a row, each with a corridor of its own",
        core::gauntlet, [](CLI::App& command, core::GauntletOptions& options) {
            add_height(command, options.height);
            add_count(command, "--walls", options.walls, "How many");
            command.add_option("--thickness", options.thickness, "Of each wall")
                ->capture_default_str();
            command
                .add_option("--least-offset", options.min_offset,
                            "Least distance in y between neighbouring corridors")
                ->capture_default_str();
            command.add_option("--room", options.room,
                               "Width of the first and the last room; default: as the chain needs");
        });
    add_family<core::RoomsOptions>(
        app, families, "rooms", "Rooms in a row with doors and shelves", core::rooms,
        [](CLI::App& command, core::RoomsOptions& options) {
            add_height(command, options.height);
            add_count(command, "--rooms", options.rooms, "How many");
            add_count(command, "--doors", options.doors, "In each wall");
            command.add_option("--thickness", options.thickness, "Of each wall")
                ->capture_default_str();
            add_count(command, "--shelves", options.shelves, "Boxes in the rooms");
            command
                .add_option("--shelf-gap", options.shelf_gap, "Least distance of shelf and door")
                ->capture_default_str();
        });
}

void add_maze_families(CLI::App& app, std::vector<Family>& families) {
    add_family<core::MazeOptions>(
        app, families, "maze", "A perfect maze of square cells", core::maze,
        [](CLI::App& command, core::MazeOptions& options) {
            add_way(command, options.way, "way");
            command.add_option("--wall", options.wall, "Least thickness of a wall")
                ->capture_default_str();
            command.add_option("--cells", options.cells, "On each side; default: what fits")
                ->check(finite_and_not_negative());
        });
    add_family<core::SpiralOptions>(
        app, families, "spiral", "A square spiral", core::spiral,
        [](CLI::App& command, core::SpiralOptions& options) {
            add_way(command, options.way, "way");
            command.add_option("--wall", options.wall, "Thickness of the walls")
                ->capture_default_str();
            command.add_option("--legs", options.legs, "Straight parts; default: what fits")
                ->check(finite_and_not_negative());
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
            command
                .add_option("--offset", options.offset, "How far off the middle the roads may be")
                ->capture_default_str();
            add_choice(command, "--start-arm", options.start_arm, "Where the start is", branches);
            add_choice(command, "--goal-arm", options.goal_arm, "Where the goal is", branches);
        });
    add_family<core::ClutterOptions>(
        app, families, "clutter", "Random boxes", core::clutter,
        [](CLI::App& command, core::ClutterOptions& options) {
            add_count(command, "--obstacles", options.obstacles, "How many");
            command.add_option("--density", options.density, "Sum of their areas")
                ->capture_default_str();
            command.add_option("--side-ratio", options.side_ratio, "Longest side to shortest side")
                ->capture_default_str();
            command.add_option(
                "--lane", options.lane,
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
