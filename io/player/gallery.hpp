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

/// Reads the files and measures what they say. The lower bound of the cost is that of the
/// statistics, or is computed. Adds what had to be forgiven to warnings. Throws
/// ParseError or ReadError.
Exhibit read_exhibit(const ExhibitFiles& files, std::vector<Warning>& warnings);

/// The files for each case: a problem file, or a folder, which stands for the .txt and .json
/// files in it in the order of their names, those of solutions, trees and statistics apart. For a
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

/// Writes, for each problem, NAME.light.svg, NAME.dark.svg and the player NAME.html into a folder,
/// which is made where it does not exist, and index.html with all of them. Problems of one name get
/// numbers. A case that cannot be read has its reason on the page. Throws WriteError.
GalleryReport write_gallery(const std::filesystem::path& folder,
                            std::span<const ExhibitFiles> exhibits);

}  // namespace asv::io
