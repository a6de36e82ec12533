#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/benchmark/machine_unit.hpp"
#include "core/benchmark/run.hpp"
#include "io/benchmark/arena_database.hpp"
#include "io/benchmark/ompl_log.hpp"
#include "io/benchmark/plot/plot.hpp"
#include "io/benchmark/runs_csv.hpp"
#include "io/benchmark/runs_json.hpp"
#include "io/benchmark/table.hpp"
#include "io/text/atomic_file.hpp"
#include "tools/bench/bench_plan.hpp"
#include "tools/bench/machine.hpp"
#include "tools/bench/run_launcher.hpp"
#include "tools/bench/run_progress.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/interrupt.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"

namespace {

namespace core = asv::core;
namespace io = asv::io;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::RunProgress;
using asv::tools::UsageError;
using std::filesystem::path;

struct Arguments {
    std::vector<std::string> problems;
    std::vector<std::string> planners = {"auto"};
    std::string direction = "forward";
    std::string table;
    std::string csv, json, ompl_log, database;
    std::vector<path> plots;
    std::string theme = "light";
    core::BenchmarkPlan plan;
    io::ReadOptions reading;
};

constexpr std::uint64_t max_seeds = 1'000'000;

void add_plan_options(CLI::App& app, Arguments& arguments) {
    core::BenchmarkPlan& plan = arguments.plan;
    app.add_option("PROBLEMS", arguments.problems,
                   "Problem files and scenarios; - for standard input")
        ->type_name(asv::tools::problem_file)
        ->required();
    asv::tools::add_reading_options(app, arguments.reading);
    app.add_option("--planner", arguments.planners,
                   "\"[LABEL:] NAME [KEY=VALUE]...\": a planner with settings, see asv-solve "
                   "--list-planners; \"all\" for every planner; may be repeated")
        ->type_name("PLANNER|all")
        ->allow_extra_args(false)
        ->capture_default_str();
    app.add_option("--seeds", plan.seeds, "Runs of each planner on each problem in each direction")
        ->transform(asv::tools::whole_number(1, max_seeds))
        ->capture_default_str();
    app.add_option("--first-seed", plan.first_seed, "The first seed; the others follow it")
        ->transform(
            asv::tools::whole_number(0, std::numeric_limits<std::uint64_t>::max() - max_seeds))
        ->capture_default_str();
    app.add_option("--direction", arguments.direction, "forward, reversed (goal to start) or both")
        ->check(CLI::IsMember({"forward", "reversed", "both"}))
        ->capture_default_str();
    app.add_option("--time-limit", plan.time_limit, "Seconds of wall clock for each run")
        ->transform(asv::tools::number_from(0))
        ->capture_default_str();
    app.add_option("--optimize", plan.optimize,
                   "Improvement after the first path, in seconds of work, as in asv-solve")
        ->transform(asv::tools::number_from(0))
        ->capture_default_str();
    app.add_option("--threads", plan.threads, "Threads of each run")
        ->transform(asv::tools::whole_number(1, asv::tools::max_threads))
        ->capture_default_str();
    app.add_option("--jobs", plan.jobs,
                   "Runs side by side: sooner done, but their times are spoilt")
        ->transform(asv::tools::whole_number(1, asv::tools::max_threads))
        ->capture_default_str();
}

void add_output_options(CLI::App& app, Arguments& arguments) {
    app.add_option("--table", arguments.table,
                   "Markdown table; - for standard output, where it goes anyway unless another "
                   "output does")
        ->type_name("FILE.md");
    app.add_option("--csv", arguments.csv, "Write one line for each run as CSV")
        ->type_name("FILE.csv");
    app.add_option("--json", arguments.json,
                   "Write session, summary, and all runs with their commands as JSON")
        ->type_name("FILE.json");
    app.add_option("--ompl-log", arguments.ompl_log,
                   "Write a text log of OMPL's benchmarks; with several problems or directions one "
                   "for each, its name before the ending")
        ->type_name("FILE.log");
    app.add_option("--database", arguments.database, "Write an SQLite database for Planner Arena")
        ->type_name("FILE.db|.sqlite");
    app.add_option("--plot", arguments.plots,
                   "Draw shares solved over time and costs: .svg, .png or .pdf, or - for an SVG on "
                   "standard output; may be repeated")
        ->type_name("FILE.svg|.png|.pdf")
        ->allow_extra_args(false);
    app.add_option("--theme", arguments.theme, "Colours of the plot: light or dark")
        ->check(CLI::IsMember({"light", "dark"}))
        ->capture_default_str();
}

io::PictureFormat format_of(const path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".svg" || file == io::standard_stream) return io::PictureFormat::svg;
    if (ending == ".png") return io::PictureFormat::png;
    if (ending == ".pdf") return io::PictureFormat::pdf;
    throw UsageError("--plot " + file.string() + ": must end in .svg, .png or .pdf");
}

void complete_plan(Arguments& arguments) {
    core::BenchmarkPlan& plan = arguments.plan;
    plan.planners = asv::tools::parse_planners(arguments.planners);
    for (const path& file : arguments.plots) static_cast<void>(format_of(file));
    plan.directions.clear();
    if (arguments.direction != "reversed") plan.directions.push_back(core::Direction::forward);
    if (arguments.direction != "forward") plan.directions.push_back(core::Direction::reversed);
}

asv::tools::FileRoles roles_of(const Arguments& arguments) {
    asv::tools::FileRoles roles;
    for (const std::string& file : arguments.problems) roles.add_input("PROBLEM", file);
    roles.add_output("--table", arguments.table);
    roles.add_output("--csv", arguments.csv);
    roles.add_output("--json", arguments.json);
    roles.add_output("--database", arguments.database);
    for (const path& file : arguments.plots) roles.add_output("--plot", file);
    return roles;
}

/// The table goes to standard output where nothing else does.
void choose_table(Arguments& arguments) {
    std::vector<path> others{arguments.csv, arguments.json, arguments.ompl_log, arguments.database};
    others.insert(others.end(), arguments.plots.begin(), arguments.plots.end());
    const bool taken = std::find(others.begin(), others.end(), io::standard_stream) != others.end();
    if (arguments.table.empty() && !taken) arguments.table = io::standard_stream;
}

/// A file to write, and its content.
struct Output {
    path file;
    std::string content;
};

/// All but the plots; pipes and devices come last, since one that nobody reads must not keep the
/// files waiting.
std::vector<Output> outputs_of(const Arguments& arguments, const io::BenchmarkReport& report) {
    std::vector<Output> outputs;
    const auto add = [&](const std::string& file, auto make) {
        if (!file.empty()) outputs.push_back({file, make(report)});
    };
    add(arguments.csv, io::runs_csv);
    add(arguments.json, io::runs_json);
    add(arguments.database, io::arena_database);
    add(arguments.table, io::markdown_table);
    if (!arguments.ompl_log.empty()) {
        const bool several = report.plan.problems.size() * report.plan.directions.size() > 1;
        for (const io::Experiment& experiment : io::experiments(report))
            outputs.push_back({io::ompl_log_file(arguments.ompl_log, experiment, several),
                               io::ompl_log(report, experiment)});
    }
    std::stable_partition(outputs.begin(), outputs.end(),
                          [](const Output& output) { return !asv::tools::is_stream(output.file); });
    return outputs;
}

/// Who has interrupted the program does not want to wait for somebody to read what it writes.
void end_without_a_reader(const Output& output) {
    constexpr std::chrono::milliseconds to_begin{100};
    constexpr std::size_t bytes_per_millisecond = 10'000;
    const std::chrono::milliseconds to_read(output.content.size() / bytes_per_millisecond);
    asv::tools::end_anyway_after(to_begin + to_read, static_cast<int>(ExitCode::interrupted));
}

/// Writes what the runs came to, and only then draws it: a plot that fails must not cost the
/// results.
void write_results(const Arguments& arguments, const io::BenchmarkReport& report,
                   bool interrupted) {
    const auto write = [&](const Output& output) {
        if (interrupted && asv::tools::is_stream(output.file)) end_without_a_reader(output);
        io::write_file(output.file, output.content);
        asv::tools::do_not_end_anyway();
    };
    for (const Output& output : outputs_of(arguments, report)) write(output);
    const io::Theme theme = arguments.theme == "dark" ? io::Theme::dark : io::Theme::light;
    for (const path& file : arguments.plots)
        write({file, io::draw_benchmark(report, format_of(file), theme)});
}

/// Finds out before an hour of runs that their results have no place to go.
void require_places(const Arguments& arguments) {
    std::vector<std::string> files{arguments.csv, arguments.json, arguments.ompl_log,
                                   arguments.database};
    if (arguments.table != "-") files.push_back(arguments.table);
    for (const path& file : arguments.plots) files.push_back(file.string());
    for (const std::string& file : files)
        if (!file.empty()) io::require_writable(file);
}

struct Runs {
    std::vector<core::BenchmarkRun> done;
    bool interrupted = false;
};

Runs run_all(core::BenchmarkPlan& plan, bool quiet) {
    asv::tools::RunLauncher launcher(plan);
    plan.jobs = launcher.jobs();
    const asv::tools::InterruptWatch interrupt;
    RunProgress progress(plan, !quiet);
    core::BenchmarkWatch watch;
    watch.before = [&](const core::RunPlace& place) { progress.begin(place); };
    watch.after = [&](const core::BenchmarkRun&) { progress.end(); };
    watch.perform = [&](const core::BenchmarkPlan&, const core::RunPlace& place,
                        const std::stop_token& abort) { return launcher.run(place, abort); };
    watch.abort = interrupt.token();
    std::vector<core::BenchmarkRun> done = core::run_benchmark(plan, watch);
    return {std::move(done), watch.abort.stop_requested()};
}

/// Reports a run that must not be: its message and the command that repeats it.
ExitCode report_fault(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run) {
    std::cerr << "asv-bench: a bug, nothing was written: " << run.fault
              << "\nIt comes again with\n  " << io::solve_command(plan, run.place) << '\n';
    return ExitCode::internal;
}

ExitCode bench(const CommandLine& command_line, Arguments& arguments) {
    complete_plan(arguments);
    choose_table(arguments);
    asv::tools::FileRoles roles = roles_of(arguments);
    roles.require_distinct();
    core::BenchmarkPlan& plan = arguments.plan;
    if (!asv::tools::read_problems(command_line, arguments.problems, arguments.reading, roles,
                                   plan.problems))
        return ExitCode::bad_input;
    for (const path& file : asv::tools::log_files(plan, arguments.ompl_log))
        roles.add_output("--ompl-log", file);
    roles.require_distinct();
    asv::tools::require_usable(plan);
    asv::tools::warn_of_idle_settings(command_line, plan);
    require_places(arguments);

    io::BenchmarkReport report;
    report.session = {ASV_VERSION, asv::tools::host_name(), asv::tools::cpu_name(),
                      std::thread::hardware_concurrency(), std::chrono::system_clock::now()};
    const auto begun = core::Clock::now();
    report.session.unit_before = core::seconds_per_million_checks();
    Runs runs = run_all(plan, command_line.quiet());
    report.runs = std::move(runs.done);
    for (const core::BenchmarkRun& run : report.runs)
        if (!run.fault.empty()) return report_fault(plan, run);
    if (report.runs.empty()) {
        std::cerr << "asv-bench: interrupted before a run had ended; nothing was written\n";
        return ExitCode::interrupted;
    }
    // Who has interrupted the runs does not want to wait for another measurement.
    report.session.unit_after =
        runs.interrupted ? report.session.unit_before : core::seconds_per_million_checks();
    report.session.total = std::chrono::duration<double>(core::Clock::now() - begun).count();
    report.plan = std::move(plan);

    write_results(arguments, report, runs.interrupted);
    return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line(
        "asv-bench",
        "Runs planners on problems with many seeds, each run as asv-solve would and in a process "
        "of its own, checks every "
        "solution once more, and tells how it went. Runs that find no path are results: the exit "
        "code is 0 all the same. Ctrl-C ends it at once; the results of the runs that have ended "
        "are "
        "written.",
        "asv-bench testcases/3ASV.txt testcases/7ASV.txt --planner auto --planner \"swaps: "
        "rrt-connect swap-limiter=on\" --direction both --csv runs.csv");
    Arguments arguments;
    add_plan_options(command_line.options(), arguments);
    add_output_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] { return bench(command_line, arguments); });
} catch (...) {
    return asv::tools::report_failed_start("asv-bench");
}
