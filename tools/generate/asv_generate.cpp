#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/generate/families.hpp"
#include "core/generate/vouch/vouch.hpp"
#include "io/problem/generation_file.hpp"
#include "io/problem/problem_file.hpp"
#include "tools/common/command_line.hpp"

namespace {

namespace core = asv::core;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::UsageError;

/// What all families have in common.
struct Arguments {
    core::ChainOptions chain;
    std::uint64_t seed = 1;
    std::string output;
    bool solvable = false;
    std::size_t attempts = 1;
};

/// Adds an option that takes one of some words; without it the first one counts.
template <class Value>
void add_choice(CLI::App& app, const std::string& name, Value& value,
                const std::string& description,
                const std::vector<std::pair<std::string, Value>>& choices) {
    std::string words;
    for (const auto& [word, meaning] : choices) words += (words.empty() ? "" : "|") + word;
    app.add_option(name, value, description)
        ->transform(CLI::CheckedTransformer(choices, CLI::ignore_case))
        ->default_str(choices.front().first)
        ->option_text(words + "=" + choices.front().first);
}

/// Adds an option that takes a whole number; a negative one would wrap round to a huge one.
template <class Count>
CLI::Option* add_count(CLI::App& app, const std::string& name, Count& value,
                       const std::string& description) {
    return app.add_option(name, value, description)
        ->check(asv::tools::finite_and_not_negative())
        ->capture_default_str();
}

/// A family's subcommand and the function that draws one of its problems.
struct Family {
    CLI::App* command;
    std::function<core::Problem(const core::ChainOptions&, core::Rng&)> draw;
};

void add_common_options(CLI::App& app, Arguments& arguments) {
    core::ChainOptions& chain = arguments.chain;
    app.add_option("-n,--asvs", chain.asv_count, "Number of ASVs, 3 to 200")
        ->check(asv::tools::finite_and_not_negative())
        ->required();
    add_count(app, "--seed", arguments.seed, "Seed of all random draws");
    app.add_option("-o,--output", arguments.output, "Problem file to write")->required();
    add_choice<core::Orientation>(app, "--orientation", chain.orientation, "Of start and goal",
                                  {{"random", core::Orientation::random},
                                   {"cw", core::Orientation::clockwise},
                                   {"ccw", core::Orientation::counter_clockwise}});
    app.add_option("--clearance", chain.clearance,
                   "Least distance of start and goal to obstacles and bounds")
        ->capture_default_str();
    app.add_option("--area-margin", chain.area_margin,
                   "How far start and goal are above the minimum area, as a share of it")
        ->capture_default_str();
    app.add_option("--least-turn", chain.min_turn,
                   "Least turn at every ASV of start and goal, in radians")
        ->capture_default_str();
    app.add_option("--least-closing", chain.min_closing_side,
                   "Least distance of the first to the last ASV of start and goal")
        ->capture_default_str();
    app.add_flag("--solvable", arguments.solvable,
                 "Check whether a simple path exists and write the verdict, solvable or unknown, "
                 "with all parameters to OUTPUT.json");
    app.add_option("--attempts", arguments.attempts,
                   "With --solvable: draw up to so many problems until one is solvable for "
                   "certain, else keep the last")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
}

void add_height(CLI::App& command, core::PassageHeight& height) {
    CLI::Option* factor =
        command
            .add_option("--height-factor", height.factor,
                        "Height of a corridor or door, as a multiple of the least height of a "
                        "flat chain")
            ->capture_default_str();
    command.add_option("--height", height.absolute, "The same in workspace units")
        ->excludes(factor);
}

void add_way(CLI::App& command, core::WayWidth& way, const std::string& name) {
    CLI::Option* factor =
        command
            .add_option("--" + name + "-factor", way.factor,
                        "Width of the " + name + ", as a multiple of the diameter of a round chain")
            ->capture_default_str();
    command.add_option("--" + name, way.absolute, "The same in workspace units")->excludes(factor);
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
                ->check(asv::tools::finite_and_not_negative());
        });
    add_family<core::SpiralOptions>(
        app, families, "spiral", "A square spiral", core::spiral,
        [](CLI::App& command, core::SpiralOptions& options) {
            add_way(command, options.way, "way");
            command.add_option("--wall", options.wall, "Thickness of the walls")
                ->capture_default_str();
            command.add_option("--legs", options.legs, "Straight parts; default: what fits")
                ->check(asv::tools::finite_and_not_negative());
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
            const std::vector<std::pair<std::string, core::Branch>> arms{
                {"random", core::Branch::random},
                {"east", core::Branch::east},
                {"north", core::Branch::north},
                {"west", core::Branch::west},
                {"south", core::Branch::south}};
            add_way(command, options.road, "road");
            command
                .add_option("--offset", options.offset, "How far off the middle the roads may be")
                ->capture_default_str();
            add_choice(command, "--start-arm", options.start_arm, "Where the start is", arms);
            add_choice(command, "--goal-arm", options.goal_arm, "Where the goal is", arms);
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

/// The options of the family and of the chain with the values that they were given or have anyway.
std::vector<std::pair<std::string, std::string>> parameters(const CLI::App& app,
                                                            const CLI::App& command) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const CLI::App* part : {&command, &app}) {
        for (const CLI::Option* option : part->get_options()) {
            if (option->get_items_expected_max() == 0 || option->get_name() == "--output" ||
                option->get_name() == "--attempts" || option->get_name() == "--seed")
                continue;
            const std::string name = option->get_lnames().front();
            const std::string value =
                option->count() > 0 ? option->results().front() : option->get_default_str();
            found.emplace_back(name, value.empty() ? "default" : value);
        }
    }
    return found;
}

ExitCode generate(const CommandLine& command_line, const CLI::App& app, const Family& family,
                  const Arguments& arguments) {
    core::Rng rng(arguments.seed);
    core::Problem problem;
    core::Verdict verdict;
    std::size_t attempt = 0;
    try {
        const std::size_t attempts = arguments.solvable ? arguments.attempts : 1;
        while (attempt < attempts && !verdict.solvable) {
            ++attempt;
            problem = family.draw(arguments.chain, rng);
            if (arguments.solvable) verdict = core::vouch(problem);
        }
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    } catch (const core::NoRoom& error) {
        throw UsageError(error.what());
    }
    asv::io::write_problem(arguments.output, problem);
    if (!arguments.solvable) return ExitCode::done;
    asv::io::write_generation(
        arguments.output + ".json",
        {arguments.output, family.command->get_name(), problem.asv_count(),
         problem.obstacles.size(), arguments.seed, attempt, parameters(app, *family.command),
         verdict.solvable, verdict.reason, ASV_VERSION});
    if (!command_line.quiet())
        std::cerr << arguments.output << ": " << (verdict.solvable ? "solvable" : "unknown") << ": "
                  << verdict.reason << '\n';
    return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
    CommandLine command_line(
        "asv-generate",
        "Writes a random problem of a family. The same arguments and seed give the same file. "
        "'asv-generate FAMILY --help' lists the family's own options.",
        "asv-generate corridor -n 7 --height-factor 1.1 --seed 3 -o corridor-7.txt");
    Arguments arguments;
    std::vector<Family> families;
    CLI::App& app = command_line.options();
    add_common_options(app, arguments);
    add_corridor_families(app, families);
    add_maze_families(app, families);
    add_open_families(app, families);
    app.require_subcommand(1);
    return command_line.run(argc, argv, [&] {
        for (const Family& family : families) {
            if (family.command->parsed()) return generate(command_line, app, family, arguments);
        }
        throw UsageError("no family was named");
    });
}
