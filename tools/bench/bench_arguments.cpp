#include "tools/bench/bench_arguments.hpp"

#include <cstdint>
#include <limits>

#include "io/benchmark/record/generated_name.hpp"
#include "tools/bench/bench_plan.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"

namespace asv::tools {

namespace {

constexpr std::uint64_t max_seeds = 1'000'000;
constexpr std::uint64_t max_megabytes = 100'000'000;
constexpr const char* whole_set = "*";

void add_problem_options(CLI::App& app, BenchArguments& arguments) {
    app.add_option("PROBLEMS", arguments.problems,
                   "Problem files and scenarios; - for standard input; \"[LABEL:] generate: FAMILY "
                   "OPTIONS...\": a problem made from the words of asv-generate")
        ->type_name(problem_file);
    CLI::Option* set =
        app.add_option("--set", arguments.set,
                       "The problems of the benchmark set whose name or family the pattern fits, "
                       "as in a shell; without one all of them (docs/benchmark-set.md)")
            ->type_name("PATTERN")
            ->expected(0, 1)
            ->default_str(whole_set);
    app.add_flag(
           "--list", arguments.list,
           "Print those problems: name, words of asv-generate, ASVs, whether there is a path, "
           "least cost known, proven bound")
        ->needs(set);
    add_reading_options(app, arguments.reading);
}

void add_plan_options(CLI::App& app, BenchArguments& arguments) {
    core::BenchmarkPlan& plan = arguments.plan;
    app.add_option(
           "--planner", arguments.planners,
           "\"[LABEL:] NAME [KEY=VALUE]...\": a planner with settings, see asv-solve "
           "--list-planners; \"all\" for every planner; \"[LABEL:] exec COMMAND\" for another "
           "program, with {problem}, {solution}, {seed} and {time} in its words; \"[LABEL:] "
           "ompl:NAME [PARAMETER=VALUE]...\" for one of OMPL, see asv-ompl --list-planners; may be "
           "repeated")
        ->type_name("PLANNER|all")
        ->allow_extra_args(false)
        ->default_str("auto");
    app.add_option("--seeds", plan.seeds, "Runs of each planner on each problem in each direction")
        ->transform(whole_number(1, max_seeds))
        ->capture_default_str();
    app.add_option("--first-seed", plan.first_seed, "The first seed; the others follow it")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max() - max_seeds))
        ->capture_default_str();
    app.add_option("--direction", arguments.direction, "forward, reversed (goal to start) or both")
        ->check(CLI::IsMember({"forward", "reversed", "both"}))
        ->capture_default_str();
    app.add_option("--time-limit", plan.time_limit, "Seconds of wall clock for each run")
        ->transform(number_from(0))
        ->capture_default_str();
    app.add_option("--optimize", plan.optimize,
                   "Improvement after the first path, in seconds of work, as in asv-solve")
        ->transform(number_from(0))
        ->capture_default_str();
    app.add_option("--threads", plan.threads, "Threads of each run")
        ->transform(whole_number(1, max_threads))
        ->capture_default_str();
    app.add_option("--jobs", plan.jobs,
                   "Runs side by side: sooner done, but their times are spoilt")
        ->transform(whole_number(1, max_threads))
        ->capture_default_str();
    app.add_option("--memory-limit", plan.memory_limit,
                   "Megabytes of memory for each run; one that wants more ends as a result of its "
                   "own kind. No limit by default")
        ->transform(whole_number(1, max_megabytes));
}

void add_record_options(CLI::App& app, BenchArguments& arguments) {
    app.add_option("--resume", arguments.resume,
                   "Write each run to this journal as it ends; where there is one of the same "
                   "benchmark already, go on with it")
        ->type_name("FILE.jsonl");
    CLI::Option* from =
        app.add_option("--from", arguments.from,
                       "Take the runs of these files, which --json or --resume have written, "
                       "instead of running problems; with --planner, run what is missing of it; "
                       "may be repeated")
            ->type_name("FILE.json|.jsonl");
    // All of this is told by the files.
    for (const char* option :
         {"PROBLEMS", "--set", "--seeds", "--first-seed", "--direction", "--time-limit",
          "--optimize", "--threads", "--memory-limit", "--resume"})
        from->excludes(app.get_option(option));
}

}  // namespace

void add_options(CLI::App& app, BenchArguments& arguments) {
    add_problem_options(app, arguments);
    add_plan_options(app, arguments);
    add_record_options(app, arguments);
    add_output_options(app, arguments.outputs);
}

std::vector<io::SetProblem> chosen_problems(const BenchArguments& arguments) {
    std::vector<io::SetProblem> chosen = io::chosen_of_set(*arguments.set);
    if (chosen.empty())
        throw UsageError("--set " + *arguments.set +
                         ": no problem or family of the set is called that; there are those of "
                         "--set --list");
    return chosen;
}

void complete(BenchArguments& arguments) {
    if (arguments.set)
        for (const io::SetProblem& problem : chosen_problems(arguments))
            arguments.problems.push_back(problem.name + ": " + io::generated_name(problem.words));
    if (arguments.problems.empty() && arguments.from.empty())
        throw UsageError("PROBLEMS is required, or --set or --from\nRun with --help for help.");
    core::BenchmarkPlan& plan = arguments.plan;
    if (arguments.planners.empty() && arguments.from.empty()) arguments.planners = {"auto"};
    plan.planners = parse_planners(arguments.planners);
    plan.directions.clear();
    if (arguments.direction != "reversed") plan.directions.push_back(core::Direction::forward);
    if (arguments.direction != "forward") plan.directions.push_back(core::Direction::reversed);
    complete(arguments.outputs);
}

}  // namespace asv::tools
