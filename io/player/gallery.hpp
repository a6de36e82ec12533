#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/drawing/exhibit.hpp"
#include "io/problem/problem_file.hpp"

namespace asv::io {

/// The files of one problem.
struct ExhibitFiles {
    std::filesystem::path problem;
    std::optional<std::filesystem::path> solution = {};
    std::optional<std::filesystem::path> trees = {};
    std::optional<std::filesystem::path> stats = {};
};

/// What was found while files were read, besides what they say.
struct ReadingNotes {
    std::vector<Warning> warnings;            ///< what had to be forgiven
    std::vector<std::filesystem::path> maps;  ///< which maps were read
};

/// Reads the files and measures what they say. The lower bound of the cost is that of the
/// statistics, or is computed. Adds to the notes. Throws ParseError or ReadError.
Exhibit read_exhibit(const ExhibitFiles& files, ReadingNotes& notes,
                     const ReadOptions& options = {});

/// The files for each case: a problem file, or a folder, which stands for the .txt and .json
/// files in it, those of solutions, trees and statistics apart; all in the natural order of their
/// paths, see naturally_before(). For a
/// problem NAME.txt, NAME.solution.txt, NAME.trees.json and NAME.stats.json are looked for in the
/// folder of solutions or, where none is given, beside the problem. Throws ReadError for a case
/// that does not exist.
std::vector<ExhibitFiles> find_exhibits(std::span<const std::filesystem::path> cases,
                                        const std::optional<std::filesystem::path>& solutions);

/// A case that could not be shown, and why.
struct GalleryFailure {
    std::string name;
    std::string reason;
};

struct GalleryReport {
    std::size_t shown = 0;
    std::vector<GalleryFailure> failures;
    std::vector<Warning> warnings;
};

/// What each of the exhibits is called in a gallery: NAME of its problem NAME.txt, with a number
/// where another one, or the page index.html, has that name.
std::vector<std::string> gallery_names(std::span<const ExhibitFiles> exhibits);

/// All files that write_gallery writes for these exhibits.
std::vector<std::filesystem::path> gallery_files(const std::filesystem::path& folder,
                                                 std::span<const ExhibitFiles> exhibits);

/// Writes, for each problem, the pictures NAME.light.svg and NAME.dark.svg, their fields alone as
/// NAME.light.small.svg and NAME.dark.small.svg, and the player NAME.html into a folder, which is
/// made where it does not exist, and index.html with all of them. A case that cannot be
/// read, or whose map is a file of the gallery, has its reason on the page. Throws WriteError.
GalleryReport write_gallery(const std::filesystem::path& folder,
                            std::span<const ExhibitFiles> exhibits,
                            const ReadOptions& options = {});

}  // namespace asv::io
