#include "tools/bench/bench_outputs.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <stdexcept>
#include <utility>

#include "io/benchmark/arena_database.hpp"
#include "io/benchmark/html/html_page.hpp"
#include "io/benchmark/ompl_log.hpp"
#include "io/benchmark/runs_csv.hpp"
#include "io/benchmark/runs_json.hpp"
#include "io/benchmark/table/table.hpp"
#include "io/text/atomic_file.hpp"
#include "tools/common/interrupt.hpp"

namespace asv::tools {

namespace {

using std::filesystem::path;

io::PictureFormat format_of(const path& file, const std::string& option) {
    const std::string ending = file.extension().string();
    if (ending == ".svg" || file == io::standard_stream) return io::PictureFormat::svg;
    if (ending == ".png") return io::PictureFormat::png;
    if (ending == ".pdf") return io::PictureFormat::pdf;
    throw UsageError(option + " " + file.string() + ": must end in .svg, .png or .pdf");
}

io::Columns columns_named(const std::string& keys) {
    try {
        return io::columns_named(keys);
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--columns: ") + error.what());
    }
}

/// "solved,rate": as --columns takes them.
std::string keys_of(std::span<const io::Column> columns) {
    std::string keys;
    for (const io::Column& column : columns) {
        if (!keys.empty()) keys += ", ";
        keys += column.key;
    }
    return keys;
}

/// A file to write, and its content.
struct Output {
    path file;
    std::string content;
};

/// All but the plots; pipes and devices come last, since one that nobody reads must not keep the
/// files waiting.
std::vector<Output> results_for(const BenchOutputs& outputs, const io::BenchmarkReport& report) {
    std::vector<Output> results;
    const auto add = [&](const std::string& file, auto make) {
        if (!file.empty()) results.push_back({file, make(report)});
    };
    add(outputs.csv, io::runs_csv);
    add(outputs.json, io::runs_json);
    add(outputs.database, io::arena_database);
    add(outputs.table, [&](const io::BenchmarkReport& all) {
        const bool latex = path(outputs.table).extension() == ".tex";
        return latex ? io::latex_table(all, outputs.columns)
                     : io::markdown_table(all, outputs.columns);
    });
    add(outputs.page,
        [&](const io::BenchmarkReport& all) { return io::html_page(all, outputs.columns); });
    if (!outputs.ompl_log.empty()) {
        const bool several = report.plan.problems.size() * report.plan.directions.size() > 1;
        for (const io::Experiment& experiment : io::experiments(report))
            results.push_back({io::ompl_log_file(outputs.ompl_log, experiment, several),
                               io::ompl_log(report, experiment)});
    }
    std::stable_partition(results.begin(), results.end(),
                          [](const Output& output) { return !is_stream(output.file); });
    return results;
}

/// Who has interrupted the program does not want to wait for somebody to read what it writes.
void end_without_a_reader(const Output& output) {
    constexpr std::chrono::milliseconds to_begin{100};
    constexpr std::size_t bytes_per_millisecond = 10'000;
    const std::chrono::milliseconds to_read(output.content.size() / bytes_per_millisecond);
    end_anyway_after(to_begin + to_read, static_cast<int>(ExitCode::interrupted));
}

void add_plot_options(CLI::App& app, BenchOutputs& outputs) {
    const std::array<const char*, 4> shown{"shares solved over time and costs",
                                           "performance profiles: times over those of the best "
                                           "planner",
                                           "costs over time, with quartiles",
                                           "median time and success over --parameter"};
    for (std::size_t i = 0; i < shown.size(); ++i)
        app.add_option(outputs.plots[i].option, outputs.plots[i].files,
                       std::string("Draw ") + shown[i] +
                           ": .svg, .png or .pdf, or - for an SVG on standard output; may be "
                           "repeated")
            ->type_name("FILE.svg|.png|.pdf")
            ->allow_extra_args(false);
    app.add_option("--parameter", outputs.parameter,
                   "What --parameter-plot and --report draw curves over: n (number of ASVs), "
                   "obstacles, or a number in the file that asv-generate --solvable has written "
                   "beside each problem")
        ->type_name("NAME");
    app.add_option("--theme", outputs.theme, "Colours of the plots: light or dark")
        ->check(CLI::IsMember({"light", "dark"}))
        ->capture_default_str();
    app.add_option("--layout", outputs.layout,
                   "Of the plots: wide, or column for a column of print, 8 or 9 cm, whose caption "
                   "says what the heading of a wide one does")
        ->check(CLI::IsMember({"wide", "column"}))
        ->capture_default_str();
}

}  // namespace

void add_output_options(CLI::App& app, BenchOutputs& outputs) {
    app.add_option("--table", outputs.table,
                   "Tables in Markdown, or in LaTeX (booktabs) where the file ends in .tex; - for "
                   "standard output, where they go anyway unless another output does")
        ->type_name("FILE.md|.tex");
    app.add_option_function<std::string>(
           "--columns",
           [&outputs](const std::string& keys) { outputs.columns = columns_named(keys); },
           "Columns of the tables, in this order. There are " + keys_of(io::all_columns()))
        ->type_name("COLUMN,...")
        ->default_str(keys_of(outputs.columns));
    app.add_option("--csv", outputs.csv, "Write one line for each run as CSV")
        ->type_name("FILE.csv");
    app.add_option("--json", outputs.json,
                   "Write session, summary, and all runs with their commands as JSON")
        ->type_name("FILE.json");
    app.add_option("--report", outputs.page,
                   "Write tables and charts that can be pointed at as one self-contained page")
        ->type_name("FILE.html");
    app.add_option("--ompl-log", outputs.ompl_log,
                   "Write a text log of OMPL's benchmarks; with several problems or directions one "
                   "for each, its name before the ending")
        ->type_name("FILE.log");
    app.add_option("--database", outputs.database, "Write an SQLite database for Planner Arena")
        ->type_name("FILE.db|.sqlite");
    add_plot_options(app, outputs);
}

void complete(BenchOutputs& outputs) {
    if (!outputs.page.empty() && !io::has_charts())
        throw UsageError(
            "--report: this program was built without charts; install Chart.js (Debian "
            "package libjs-chart.js) and build it again");
    if (!outputs.plots.back().files.empty() && outputs.parameter.empty())
        throw UsageError("--parameter-plot wants --parameter NAME");
    std::vector<path> others{outputs.csv, outputs.json, outputs.page, outputs.ompl_log,
                             outputs.database};
    for (const BenchOutputs::Plots& plots : outputs.plots)
        for (const path& file : plots.files) {
            static_cast<void>(format_of(file, plots.option));
            others.push_back(file);
        }
    const bool taken = std::find(others.begin(), others.end(), io::standard_stream) != others.end();
    if (outputs.table.empty() && !taken) outputs.table = io::standard_stream;
}

void add_roles(const BenchOutputs& outputs, FileRoles& roles) {
    roles.add_output("--table", outputs.table);
    roles.add_output("--csv", outputs.csv);
    roles.add_output("--json", outputs.json);
    roles.add_output("--report", outputs.page);
    roles.add_output("--database", outputs.database);
    for (const BenchOutputs::Plots& plots : outputs.plots)
        for (const path& file : plots.files) roles.add_output(plots.option, file);
}

void require_places(const BenchOutputs& outputs) {
    std::vector<std::string> files{outputs.csv, outputs.json, outputs.page, outputs.ompl_log,
                                   outputs.database};
    if (outputs.table != io::standard_stream) files.push_back(outputs.table);
    for (const BenchOutputs::Plots& plots : outputs.plots)
        for (const path& file : plots.files) files.push_back(file.string());
    for (const std::string& file : files)
        if (!file.empty()) io::require_writable(file);
}

void write_results(const BenchOutputs& outputs, const io::BenchmarkReport& report,
                   bool interrupted) {
    const auto write = [&](const Output& output) {
        if (interrupted && is_stream(output.file)) end_without_a_reader(output);
        io::write_file(output.file, output.content);
        do_not_end_anyway();
    };
    for (const Output& output : results_for(outputs, report)) write(output);
    const io::Theme theme = outputs.theme == "dark" ? io::Theme::dark : io::Theme::light;
    const io::PlotLayout layout =
        outputs.layout == "column" ? io::PlotLayout::column : io::PlotLayout::wide;
    for (const BenchOutputs::Plots& plots : outputs.plots)
        for (const path& file : plots.files)
            write({file, plots.draw(report, format_of(file, plots.option), theme, layout)});
}

}  // namespace asv::tools
