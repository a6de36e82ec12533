#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "io/benchmark/plot/curve_plots.hpp"
#include "io/benchmark/plot/plot.hpp"
#include "io/benchmark/report.hpp"
#include "io/benchmark/table/columns.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"

namespace asv::tools {

/// The files that a benchmark writes; an empty name stands for none.
struct BenchOutputs {
    std::string table, csv, json, page, ompl_log, database;
    /// A kind of picture and its files.
    struct Plots {
        const char* option;
        std::string (*draw)(const io::BenchmarkReport&, io::PictureFormat, io::Theme,
                            io::PlotLayout);
        std::vector<std::filesystem::path> files;
    };
    std::array<Plots, 4> plots{{{"--plot", io::draw_benchmark, {}},
                                {"--profile", io::draw_profiles, {}},
                                {"--anytime", io::draw_costs_over_time, {}},
                                {"--parameter-plot", io::draw_parameter, {}}}};
    std::string parameter;        ///< of the problems, to draw curves over; empty for none
    std::string theme = "light";  ///< of the plots
    std::string layout = "wide";  ///< of the plots
    io::Columns columns = io::default_columns();
};

void add_output_options(CLI::App& app, BenchOutputs& outputs);

/// Sends the table to standard output where nothing else goes there. Throws UsageError for a plot
/// of a format that there is not, one over no parameter, and a page that this build cannot make.
void complete(BenchOutputs& outputs);

/// All but the logs, whose names depend on the problems; see log_files().
void add_roles(const BenchOutputs& outputs, FileRoles& roles);

/// Finds out before an hour of runs that their results have no place to go: throws WriteError.
void require_places(const BenchOutputs& outputs);

/// Writes what the runs came to, and only then draws it: a plot that fails must not cost the
/// results. Who has interrupted the program is not kept waiting for a reader of a pipe: where none
/// begins to read, the process ends with exit code 130. Throws WriteError.
void write_results(const BenchOutputs& outputs, const io::BenchmarkReport& report,
                   bool interrupted);

}  // namespace asv::tools
