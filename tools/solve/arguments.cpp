#include "tools/solve/arguments.hpp"

#include <algorithm>
#include <iostream>
#include <limits>
#include <thread>

#include "tools/common/motion_limits_options.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"
#include "tools/solve/planner_list.hpp"

namespace asv::tools {

namespace {

void add_numbers(CLI::App& app, core::SolveOptions& solve) {
    app.add_option("--seed", solve.seed, "Seed of all random draws")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    app.add_option("--time-limit", solve.time_limit, "Seconds of wall clock for everything")
        ->transform(number_from(0))
        ->capture_default_str();
    app.add_option("--optimize", solve.optimize,
                   "Improvement after the first solution, in seconds of work of a 2.8 GHz core; "
                   "counted, not timed, so that the same seed gives the same file")
        ->transform(number_from(0))
        ->capture_default_str();
    solve.threads = std::max(1U, std::thread::hardware_concurrency());
    app.add_option("--threads", solve.threads, "Threads that race; default: the processors")
        ->transform(whole_number(1, max_threads));
}

/// Behind the options of the files that only a single problem can fill.
void add_batch(CLI::App& app, SolveArguments& arguments) {
    CLI::Option* batch =
        app.add_option("--batch", arguments.batch,
                       "Answer the queries of this file about the world of PROBLEM, a line of JSON "
                       "each, --threads of them at once; - for standard input")
            ->type_name("FILE.jsonl");
    for (const char* file : {"--stats", "--certificate", "--trajectory", "--trees"})
        batch->excludes(app.get_option(file));
    app.add_option("--solutions", arguments.solutions,
                   "Write the solution of each query that has one to LINE.txt in this folder")
        ->type_name("FOLDER")
        ->needs(batch);
}

}  // namespace

void add_options(CLI::App& app, SolveArguments& arguments) {
    app.add_option("PROBLEM", arguments.problem, "Problem file; - for standard input")
        ->type_name(problem_file)
        ->required();
    app.add_option("SOLUTION", arguments.solution,
                   "Solution file to write, with --batch the answers; - for standard output")
        ->type_name("FILE.txt|.jsonl")
        ->required();
    app.add_option("--planner", arguments.planner, "Planner, see --list-planners")
        ->type_name("PLANNER")
        ->capture_default_str();
    app.add_option("--set", arguments.settings,
                   "A setting of the planner, see --list-planners; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    add_numbers(app, arguments.solve);
    app.add_option("--stats", arguments.stats, "Write what the run found and spent as JSON")
        ->type_name("FILE.json");
    app.add_option("--certificate", arguments.certificate,
                   "Where the problem is proven infeasible, write the proof as JSON, which "
                   "asv-validate checks; else nothing, and say so")
        ->type_name("FILE.json");
    CLI::Option* trajectory =
        app.add_option("--trajectory", arguments.trajectory,
                       "Write the path with times, as fast as --speed and --acceleration allow; "
                       "the ending tells the format, - is CSV on standard output")
            ->type_name("FILE.csv|.json|.yaml");
    add_motion_limits(app, arguments.limits, trajectory);
    app.add_option("--trees", arguments.trees,
                   "Write the search trees as JSON; left out where the time limit leaves none")
        ->type_name("FILE.json");
    add_batch(app, arguments);
    add_reading_options(app, arguments.reading);
    app.add_flag("--reverse", arguments.solve.reverse,
                 "Plan from goal to start; the file still leads from start to goal");
    CLI::Option* markdown =
        app.add_flag("--markdown", arguments.markdown, "With --list-planners: as docs/settings.md");
    markdown->needs(app.add_flag_callback(
        "--list-planners",
        [&arguments] {
            if (arguments.markdown)
                list_planners_as_markdown(std::cout);
            else
                list_planners(std::cout);
            throw CLI::Success();
        },
        "List all planners with their settings and exit"));
}

core::Planner chosen_planner(const SolveArguments& arguments) {
    try {
        core::Planner planner = core::planner_named(arguments.planner);
        for (const std::string& setting : arguments.settings) {
            const std::size_t equals = setting.find('=');
            if (equals == std::string::npos)
                throw std::invalid_argument("--set wants KEY=VALUE, not '" + setting + "'");
            core::set(planner, setting.substr(0, equals), setting.substr(equals + 1));
        }
        return planner;
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

void require_usable_planner(const SolveArguments& arguments, core::BodyKind body) {
    try {
        core::require_usable(arguments.solve.planner, body);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

}  // namespace asv::tools
