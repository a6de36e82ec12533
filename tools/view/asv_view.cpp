#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/drawing/animation.hpp"
#include "io/drawing/drawing.hpp"
#include "io/player/gallery.hpp"
#include "io/player/player.hpp"
#include "io/text/atomic_file.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/file_roles.hpp"
#include "tools/common/number_options.hpp"
#include "tools/common/reading.hpp"
#include "tools/view/film.hpp"
#include "tools/view/numbered_name.hpp"

namespace {

using asv::io::Exhibit;
using asv::io::PictureFormat;
using asv::io::Theme;
using asv::tools::CommandLine;
using asv::tools::ExitCode;
using asv::tools::FileRoles;
using asv::tools::NumberedName;
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
    std::optional<double> seconds;
    std::optional<unsigned> fps;
    asv::io::ReadOptions reading;
};

/// The kinds of output, by the ending of the file name; a page stands for the player. A png whose
/// name has a place for a number is one picture of a film for each number.
enum class Kind { svg, png, pdf, page, film, numbered };

const std::map<std::string, Kind> kinds{
    {".svg", Kind::svg},  {".png", Kind::png},  {".pdf", Kind::pdf},  {".html", Kind::page},
    {".gif", Kind::film}, {".mp4", Kind::film}, {".webm", Kind::film}};

constexpr double usual_seconds = 8;
constexpr double most_seconds = 600;
constexpr unsigned usual_fps = 25;
constexpr unsigned most_fps = 60;

bool is_animated(Kind kind) {
    return kind == Kind::film || kind == Kind::numbered;
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("FILES", arguments.inputs,
                   "PROBLEM [SOLUTION], - for standard input; with --gallery any number of problem "
                   "files and folders")
        ->type_name(asv::tools::problem_file)
        ->required();
    app.add_option(
           "-o,--output", arguments.outputs,
           "File to write: .svg, .png, .pdf, .html for the player, .gif, .mp4 or .webm for a film, "
           "NAME-%04d.png for its pictures; - for standard output; several -o allowed")
        ->type_name("FILE.svg|.png|.pdf|.html|.gif|.mp4|.webm")
        ->allow_extra_args(false);
    app.add_option("--format", arguments.format,
                   "What -o - is: svg, png, pdf, html, gif, mp4 or webm")
        ->check(CLI::IsMember({"svg", "png", "pdf", "html", "gif", "mp4", "webm"}))
        ->capture_default_str();
    app.add_option("--seconds", arguments.seconds, "How long a film takes (8)")
        ->transform(asv::tools::number_between(0.1, most_seconds));
    app.add_option("--fps", arguments.fps, "Pictures of a film in each second (25)")
        ->transform(asv::tools::whole_number(1, most_fps));
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

std::string ending_of(const Arguments& arguments, const path& file) {
    return file == asv::io::standard_stream ? "." + arguments.format : file.extension().string();
}

Kind kind_of(const Arguments& arguments, const path& file) {
    const auto kind = kinds.find(ending_of(arguments, file));
    if (kind == kinds.end()) {
        throw UsageError("-o " + file.string() +
                         ": must end in .svg, .png, .pdf, .html, .gif, .mp4 or .webm");
    }
    if (kind->second == Kind::png && NumberedName::of(file)) return Kind::numbered;
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
    bool animated = false;
    for (const path& output : arguments.outputs)
        animated = is_animated(kind_of(arguments, output)) || animated;
    if (animated && arguments.inputs.size() < 2)
        throw UsageError("a film needs a solution: PROBLEM SOLUTION");
    if (!animated && (arguments.seconds || arguments.fps))
        throw UsageError(
            "--seconds and --fps are for films: -o with .gif, .mp4, .webm or NAME-%d.png");
}

std::size_t picture_count(const Arguments& arguments) {
    const double pictures = arguments.seconds.value_or(usual_seconds) *
                            static_cast<double>(arguments.fps.value_or(usual_fps));
    return std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(pictures)));
}

/// The names of all files that an output stands for.
std::vector<path> files_of(const Arguments& arguments, const path& output) {
    if (kind_of(arguments, output) != Kind::numbered) return {output};
    const NumberedName name = *NumberedName::of(output);
    std::vector<path> files;
    for (std::size_t i = 0; i < picture_count(arguments); ++i) files.push_back(name.at(i));
    return files;
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
        case Kind::film:
        case Kind::numbered:
            break;
    }
    throw std::logic_error("a film is no single picture");
}

/// A film, or its pictures one by one.
void write_animation(const Arguments& arguments, const Exhibit& exhibit, const path& output,
                     Theme theme) {
    const asv::io::Animation animation(exhibit, theme, picture_count(arguments));
    if (const auto format = asv::tools::film_format(ending_of(arguments, output)))
        return asv::io::write_file(
            output, make_film(animation, *format, arguments.fps.value_or(usual_fps)));
    const std::vector<path> files = files_of(arguments, output);
    for (std::size_t i = 0; i < files.size(); ++i)
        asv::io::write_file(files[i], animation.picture(i));
}

void write_output(const Arguments& arguments, const Exhibit& exhibit, const path& output) {
    const Theme theme = arguments.theme == "dark" ? Theme::dark : Theme::light;
    const Kind kind = kind_of(arguments, output);
    if (is_animated(kind))
        write_animation(arguments, exhibit, output, theme);
    else
        asv::io::write_file(output, produce(exhibit, kind, theme));
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
    for (const path& output : arguments.outputs)
        for (const path& file : files_of(arguments, output)) roles.add_output("-o", file);
    roles.require_distinct();
    asv::io::ReadingNotes notes;
    Exhibit exhibit = read_exhibit(files, notes, arguments.reading);
    command_line.print(notes.warnings);
    for (const path& map : notes.maps) roles.add_input("the map of the scenario", map);
    roles.require_distinct();
    if (arguments.bound) exhibit.lower_bound = arguments.bound;
    for (const path& output : arguments.outputs) write_output(arguments, exhibit, output);
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
