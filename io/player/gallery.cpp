#include "io/player/gallery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/bounds/lower_bound.hpp"
#include "core/validation/validate.hpp"
#include "io/drawing/drawing.hpp"
#include "io/player/assets.hpp"
#include "io/player/player.hpp"
#include "io/solution/run_facts.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/markup.hpp"
#include "io/text/natural_order.hpp"
#include "io/text/number_text.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view solution_ending = ".solution.txt";
constexpr std::string_view trees_ending = ".trees.json";
constexpr std::string_view stats_ending = ".stats.json";

/// What a gallery has of each exhibit.
constexpr std::array<std::string_view, 5> endings = {".light.svg", ".dark.svg", ".light.small.svg",
                                                     ".dark.small.svg", ".html"};

/// Throws ReadError when a map is about to be overwritten.
void require_apart(std::span<const fs::path> maps, std::span<const fs::path> outputs) {
    for (const fs::path& map : maps)
        for (const fs::path& output : outputs) {
            std::error_code does_not_exist;
            if (fs::equivalent(map, output, does_not_exist))
                throw ReadError(map.string() + ": the map would be overwritten by the gallery");
        }
}

/// Classic files and scenarios; not what asv-solve has written beside them.
bool names_a_problem(std::string_view name) {
    if (name.ends_with(".txt")) return !name.ends_with(solution_ending);
    return name.ends_with(".json") && !name.ends_with(trees_ending) &&
           !name.ends_with(stats_ending);
}

std::vector<fs::path> problems_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && names_a_problem(name)) {
            files.push_back(entry.path());
        }
    }
    return files;
}

ExhibitFiles with_companions(const fs::path& problem, const fs::path& folder) {
    const auto companion = [&](std::string_view ending) -> std::optional<fs::path> {
        fs::path file = folder / problem.stem();
        file += ending;
        if (!fs::exists(file)) return std::nullopt;
        return file;
    };
    return {problem, companion(solution_ending), companion(trees_ending), companion(stats_ending)};
}

/// A file name as part of an address: everything but letters, digits and -_. as %XX.
std::string address(std::string_view name) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) ||
                           c == '-' || c == '_' || c == '.';
        if (plain) {
            result += c;
        } else {
            result += '%';
            result += digits[byte >> 4];
            result += digits[byte & 15];
        }
    }
    return result;
}

/// A link to the picture in one of the colours.
std::string picture_link(const std::string& base, const std::string& name, const char* colours) {
    return "<a href=\"" + base + "." + colours + ".svg\" aria-label=\"Picture of " + name + ", " +
           colours + "\">" + colours + "</a>";
}

std::string card(const Exhibit& exhibit, const std::string& file) {
    const std::string name = escape_markup(exhibit.name);
    const bool good = exhibit.report.valid();
    const std::string base = address(file);
    std::string text = "<li>\n<h2><a href=\"" + base + ".html\">" + name + "</a></h2>\n";
    text += "<a href=\"" + base + ".html\" tabindex=\"-1\" aria-hidden=\"true\"><picture>\n" +
            "<source media=\"(prefers-color-scheme: dark)\" srcset=\"" + base +
            ".dark.small.svg\">\n<img src=\"" + base +
            ".light.small.svg\" alt=\"\" loading=\"lazy\"></picture></a>\n";
    text += "<p>" + escape_markup(facts(exhibit)) + "</p>\n";
    text += "<p class=\"verdict" + std::string(good ? "" : " bad") + "\">" + (good ? "✓ " : "✗ ") +
            escape_markup(verdict(exhibit)) + "</p>\n";
    text += "<p>Picture: " + picture_link(base, name, "light") + ", " +
            picture_link(base, name, "dark") + "</p>\n</li>\n";
    return text;
}

/// A page may be shown to people who need not know where its files lay.
std::string without_folders(std::string reason, const ExhibitFiles& files) {
    for (const auto& file :
         {std::optional(files.problem), files.solution, files.trees, files.stats}) {
        if (!file || !file->has_parent_path()) continue;
        const std::string folder = file->parent_path().string() + "/";
        if (reason.starts_with(folder)) return reason.substr(folder.size());
    }
    return reason;
}

std::string failure_card(const std::string& name, const std::string& reason) {
    return "<li>\n<h2>" + escape_markup(name) + "</h2>\n<p class=\"verdict bad\">✗ " +
           escape_markup(reason) + "</p>\n</li>\n";
}

std::string index_page(const std::string& cards, const GalleryReport& report) {
    std::string page(assets::gallery);
    const auto fill = [&](std::string_view mark, std::string_view content) {
        page.replace(page.find(mark), mark.size(), content);
    };
    const std::size_t failed = report.failures.size();
    std::string count = std::to_string(report.shown);
    count += report.shown == 1 ? " problem" : " problems";
    if (failed > 0) count.append(", ").append(std::to_string(failed)).append(" not readable");
    fill("@COUNT@", count);
    fill("@CARDS@", cards);
    return page;
}

/// None where start or goal is not valid, or no way exists.
std::optional<double> lower_bound_of(const core::Problem& problem) {
    const core::ValidationOptions options{.tolerance = problem.requirements.tolerance};
    const bool valid = core::validate_state(problem, problem.start, options).valid() &&
                       core::validate_state(problem, problem.goal, options).valid();
    if (!valid) return std::nullopt;
    const double bound = core::cost_lower_bound(problem).total;
    if (!std::isfinite(bound)) return std::nullopt;
    return bound;
}

}  // namespace

Exhibit read_exhibit(const ExhibitFiles& files, ReadingNotes& notes, const ReadOptions& options) {
    ProblemFile problem = read_problem(files.problem, options);
    notes.warnings.insert(notes.warnings.end(), problem.warnings.begin(), problem.warnings.end());
    notes.maps.insert(notes.maps.end(), problem.maps.begin(), problem.maps.end());
    ExhibitInput input;
    input.name = fs::path(input_name(files.problem)).stem().string();
    input.problem = std::move(problem.problem);
    input.unit = std::move(problem.unit);
    if (files.solution) {
        input.solution = read_solution(*files.solution, input.problem.asv_count(), &notes.warnings);
    }
    if (files.trees) input.trees = read_trees(*files.trees);
    RunFacts run;
    if (files.stats) run = read_run_facts(*files.stats);
    input.planner = run.planner;
    input.lower_bound = run.lower_bound ? run.lower_bound : lower_bound_of(input.problem);
    return make_exhibit(std::move(input));
}

std::vector<ExhibitFiles> find_exhibits(std::span<const fs::path> cases,
                                        const std::optional<fs::path>& solutions) {
    std::vector<ExhibitFiles> result;
    for (const fs::path& path : cases) {
        if (!fs::exists(path)) throw ReadError(path.string() + ": no such file or folder");
        const std::vector<fs::path> problems =
            fs::is_directory(path) ? problems_in(path) : std::vector<fs::path>{path};
        for (const fs::path& problem : problems) {
            result.push_back(with_companions(problem, solutions.value_or(problem.parent_path())));
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
        return naturally_before(a.problem.native(), b.problem.native());
    });
    return result;
}

std::vector<std::string> gallery_names(std::span<const ExhibitFiles> exhibits) {
    std::vector<std::string> names;
    std::set<std::string> taken{"index"};
    for (const ExhibitFiles& files : exhibits) {
        const std::string stem = fs::path(input_name(files.problem)).stem().string();
        std::string name = stem;
        for (std::size_t number = 2; !taken.insert(name).second; ++number)
            name = stem + "-" + std::to_string(number);
        names.push_back(name);
    }
    return names;
}

std::vector<fs::path> gallery_files(const fs::path& folder,
                                    std::span<const ExhibitFiles> exhibits) {
    std::vector<fs::path> files{folder / "index.html"};
    for (const std::string& name : gallery_names(exhibits))
        for (const std::string_view ending : endings)
            files.push_back(folder / (name + std::string(ending)));
    return files;
}

GalleryReport write_gallery(const fs::path& folder, std::span<const ExhibitFiles> exhibits,
                            const ReadOptions& options) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw WriteError(folder.string() + ": " + error.message());
    GalleryReport report;
    std::string cards;
    const std::vector<std::string> names = gallery_names(exhibits);
    const std::vector<fs::path> outputs = gallery_files(folder, exhibits);
    for (std::size_t i = 0; i < exhibits.size(); ++i) {
        const ExhibitFiles& files = exhibits[i];
        const std::string& name = names[i];
        const auto fail = [&](const char* reason) {
            report.failures.push_back({name, reason});
            cards += failure_card(name, without_folders(reason, files));
        };
        try {
            ReadingNotes notes;
            const Exhibit exhibit = read_exhibit(files, notes, options);
            report.warnings.insert(report.warnings.end(), notes.warnings.begin(),
                                   notes.warnings.end());
            require_apart(notes.maps, outputs);
            for (const auto& [theme, colours] :
                 {std::pair{Theme::light, ".light"}, std::pair{Theme::dark, ".dark"}}) {
                const std::string base = name + colours;
                write_file(folder / (base + ".svg"),
                           draw_picture(exhibit, PictureFormat::svg, theme));
                write_file(folder / (base + ".small.svg"), draw_thumbnail(exhibit, theme));
            }
            write_file(folder / (name + ".html"), make_player(exhibit));
            cards += card(exhibit, name);
            ++report.shown;
        } catch (const ParseError& problem) {
            fail(problem.what());
        } catch (const ReadError& problem) {
            fail(problem.what());
        }
    }
    write_file(folder / "index.html", index_page(cards, report));
    return report;
}

}  // namespace asv::io
