#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/drawing/drawing.hpp"
#include "io/player/gallery.hpp"
#include "io/player/player.hpp"
#include "io/text/atomic_file.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"

namespace {

using asv::io::Exhibit;
using asv::io::PictureFormat;
using asv::io::Theme;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::FileRoles;
using asv::tools::UsageError;
using std::filesystem::path;

struct Arguments {
    std::vector<path> inputs;
    std::vector<path> outputs;
    std::string trees;
    std::string stats;
    std::optional<double> bound;
    std::string gallery;
    std::string solutions;
    std::string theme = "light";
    std::string format = "svg";
    asv::io::ReadOptions reading;
};

/// The kinds of output, by the ending of the file name; a page stands for the player.
enum class Kind { svg, png, pdf, page };

const std::map<std::string, Kind> kinds{
    {".svg", Kind::svg}, {".png", Kind::png}, {".pdf", Kind::pdf}, {".html", Kind::page}};

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("FILES", arguments.inputs,
                   "PROBLEM [SOLUTION], - for standard input; with --gallery any number of problem "
                   "files and folders")
        ->type_name(asv::tools::problem_file)
        ->required();
    app.add_option(
           "-o,--output", arguments.outputs,
           "File to write: .svg, .png, .pdf, or .html for the player; - for standard output; "
           "several -o allowed")
        ->type_name("FILE.svg|.png|.pdf|.html")
        ->allow_extra_args(false);
    app.add_option("--format", arguments.format, "What -o - is: svg, png, pdf or html")
        ->check(CLI::IsMember({"svg", "png", "pdf", "html"}))
        ->capture_default_str();
    app.add_option("--trees", arguments.trees, "Search trees, as asv-solve --trees writes them")
        ->type_name("FILE.json");
    app.add_option("--stats", arguments.stats,
                   "Show the planner, and take the lower bound, from a file of asv-solve --stats")
        ->type_name("FILE.json");
    app.add_option("--bound", arguments.bound,
                   "Show this lower bound of the cost instead of computing one")
        ->transform(asv::tools::number_from(0));
    app.add_option("--theme", arguments.theme,
                   "Colours of pictures: light or dark (the player follows its reader)")
        ->check(CLI::IsMember({"light", "dark"}))
        ->capture_default_str();
    app.add_option("--gallery", arguments.gallery,
                   "Write pictures and players of all FILES and an index.html to this folder")
        ->type_name("FOLDER");
    app.add_option("--solutions", arguments.solutions,
                   "With --gallery: where NAME.solution.txt, NAME.trees.json and NAME.stats.json "
                   "are, if not beside the problems")
        ->type_name("FOLDER");
    asv::tools::add_reading_options(app, arguments.reading);
}

Kind kind_of(const Arguments& arguments, const path& file) {
    const bool standard = file == asv::io::standard_stream;
    const auto kind = kinds.find(standard ? "." + arguments.format : file.extension().string());
    if (kind == kinds.end()) {
        throw UsageError("-o " + file.string() + ": must end in .svg, .png, .pdf or .html");
    }
    return kind->second;
}

std::optional<path> given(const std::string& name) {
    if (name.empty()) return std::nullopt;
    return path(name);
}

void check_usage(const Arguments& arguments) {
    if (!arguments.gallery.empty()) {
        const bool single = !arguments.outputs.empty() || !arguments.trees.empty() ||
                            !arguments.stats.empty() || arguments.bound;
        if (single) throw UsageError("--gallery goes without -o, --trees, --stats and --bound");
        return;
    }
    if (!arguments.solutions.empty()) throw UsageError("--solutions needs --gallery");
    if (arguments.inputs.size() > 2) throw UsageError("expected PROBLEM [SOLUTION], found more");
    if (arguments.outputs.empty()) throw UsageError("-o FILE or --gallery OUT_DIR is required");
    for (const path& output : arguments.outputs) static_cast<void>(kind_of(arguments, output));
}

std::string produce(const Exhibit& exhibit, Kind kind, Theme theme) {
    switch (kind) {
        case Kind::svg:
            return draw_picture(exhibit, PictureFormat::svg, theme);
        case Kind::png:
            return draw_picture(exhibit, PictureFormat::png, theme);
        case Kind::pdf:
            return draw_picture(exhibit, PictureFormat::pdf, theme);
        case Kind::page:
            return make_player(exhibit);
    }
    return {};
}

ExitCode show_one(const CommandLine& command_line, const Arguments& arguments) {
    asv::io::ExhibitFiles files{
        arguments.inputs[0], {}, given(arguments.trees), given(arguments.stats)};
    if (arguments.inputs.size() > 1) files.solution = arguments.inputs[1];
    FileRoles roles;
    roles.add_input("PROBLEM", files.problem);
    if (files.solution) roles.add_input("SOLUTION", *files.solution);
    roles.add_input("--trees", arguments.trees);
    roles.add_input("--stats", arguments.stats);
    for (const path& output : arguments.outputs) roles.add_output("-o", output);
    roles.require_distinct();
    asv::io::ReadingNotes notes;
    Exhibit exhibit = read_exhibit(files, notes, arguments.reading);
    command_line.print(notes.warnings);
    for (const path& map : notes.maps) roles.add_input("the map of the scenario", map);
    roles.require_distinct();
    if (arguments.bound) exhibit.lower_bound = arguments.bound;
    const Theme theme = arguments.theme == "dark" ? Theme::dark : Theme::light;
    for (const path& output : arguments.outputs) {
        asv::io::write_file(output, produce(exhibit, kind_of(arguments, output), theme));
    }
    return ExitCode::done;
}

ExitCode show_gallery(const CommandLine& command_line, const Arguments& arguments) {
    const auto exhibits = asv::io::find_exhibits(arguments.inputs, given(arguments.solutions));
    FileRoles roles;
    for (const asv::io::ExhibitFiles& files : exhibits) {
        roles.add_input("a problem", files.problem);
        if (files.solution) roles.add_input("a solution", *files.solution);
        if (files.trees) roles.add_input("a file of trees", *files.trees);
        if (files.stats) roles.add_input("a file of statistics", *files.stats);
    }
    for (const path& file : asv::io::gallery_files(arguments.gallery, exhibits))
        roles.add_output("a file of the gallery", file);
    roles.require_distinct();
    const asv::io::GalleryReport report =
        asv::io::write_gallery(arguments.gallery, exhibits, arguments.reading);
    command_line.print(report.warnings);
    for (const asv::io::GalleryFailure& failure : report.failures) {
        std::cerr << failure.reason << '\n';
    }
    return report.failures.empty() ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

int main(int argc, char** argv) try {
    CommandLine command_line("asv-view",
                             "Draws a problem and its solution, makes a player of it, or lays out "
                             "a gallery of many.",
                             "asv-view testcases/7ASV.txt solution.txt -o 7ASV.svg -o 7ASV.html");
    Arguments arguments;
    add_options(command_line.options(), arguments);
    return command_line.run(argc, argv, [&] {
        check_usage(arguments);
        return arguments.gallery.empty() ? show_one(command_line, arguments)
                                         : show_gallery(command_line, arguments);
    });
} catch (...) {
    return asv::tools::report_failed_start("asv-view");
}
