#include "io/problem/problem_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/problem/scenario_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/number_text.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {
namespace {

using geometry::Box;
using geometry::Point;

constexpr std::size_t max_warnings = 100;

class ProblemReader {
  public:
    ProblemReader(std::string_view text, const std::string& name) : scanner_(text, name) {}

    ProblemFile read() {
        if (scanner_.had_byte_order_mark()) warn("byte order mark ignored");
        const std::uint64_t asv_count = read_count("the number of ASVs", 1);
        core::Problem& problem = result_.problem;
        problem.start = read_positions(asv_count, "the start");
        problem.goal = read_positions(asv_count, "the goal");
        const std::uint64_t obstacle_count = read_count("the number of obstacles", 0);
        // Only what is there is stored: the count may promise more than any memory holds.
        for (std::uint64_t i = 0; i < obstacle_count; ++i) {
            problem.obstacles.push_back(read_obstacle(i, obstacle_count));
        }
        if (!scanner_.at_end()) warn_about_rest(obstacle_count);
        if (unlisted_warnings_ > 0) {
            result_.warnings.back().message +=
                " (" + std::to_string(unlisted_warnings_) + " further warnings are not listed)";
        }
        return std::move(result_);
    }

  private:
    void warn(std::string message) {
        if (result_.warnings.size() < max_warnings) {
            result_.warnings.push_back({scanner_.name(), scanner_.line(), std::move(message)});
        } else {
            ++unlisted_warnings_;
        }
    }

    std::uint64_t read_count(const std::string& what, std::uint64_t least) {
        const std::optional<std::uint64_t> count = scanner_.count(least);
        if (!count)
            throw scanner_.error(what + " (a whole number, at least " + std::to_string(least) +
                                 ")");
        if (!scanner_.at_line_end()) throw scanner_.error("nothing more on this line");
        scanner_.next_line();
        return *count;
    }

    /// owner() names what the point belongs to; it is put into words only for an error.
    template <typename Owner>
    Point read_point(const Owner& owner) {
        const double x = scanner_.require_number([&] { return "a number (x of " + owner() + ")"; });
        const double y = scanner_.require_number([&] { return "a number (y of " + owner() + ")"; });
        return {x, y};
    }

    std::vector<Point> read_positions(std::uint64_t asv_count, const std::string& where) {
        std::vector<Point> positions;
        for (std::uint64_t i = 0; i < asv_count; ++i) {
            positions.push_back(
                read_point([&] { return "ASV " + std::to_string(i + 1) + " of " + where; }));
        }
        std::size_t extra = 0;
        while (!scanner_.at_line_end()) {
            if (!scanner_.number()) throw scanner_.error("a number or the end of the line");
            ++extra;
        }
        if (extra > 0) {
            warn("more than " + std::to_string(asv_count) + " positions for " + where +
                 ": the last " + std::to_string(extra) + " numbers ignored");
        }
        scanner_.next_line();
        return positions;
    }

    Box read_obstacle(std::uint64_t index, std::uint64_t obstacle_count) {
        if (scanner_.at_end()) {
            throw scanner_.error("obstacle " + std::to_string(index + 1) + " of " +
                                 std::to_string(obstacle_count));
        }
        std::array<Point, 4> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] = read_point([&] {
                return "corner " + std::to_string(i + 1) + " of obstacle " +
                       std::to_string(index + 1);
            });
        }
        if (!scanner_.at_line_end()) throw scanner_.error("nothing more after the fourth corner");
        const Box box = bounding_box(corners);
        warn_about_corners(corners, box, index);
        scanner_.next_line();
        return box;
    }

    static Box bounding_box(const std::array<Point, 4>& corners) {
        Box box{corners[0], corners[0]};
        for (const Point& corner : corners) {
            box.low = {std::min(box.low.x, corner.x), std::min(box.low.y, corner.y)};
            box.high = {std::max(box.high.x, corner.x), std::max(box.high.y, corner.y)};
        }
        return box;
    }

    void warn_about_corners(const std::array<Point, 4>& corners, const Box& box,
                            std::uint64_t index) {
        const std::array<Point, 4> ideal = {box.low, Point{box.high.x, box.low.y}, box.high,
                                            Point{box.low.x, box.high.y}};
        const auto is_corner = [&](const Point& point) {
            return std::find(ideal.begin(), ideal.end(), point) != ideal.end();
        };
        const std::string obstacle = "obstacle " + std::to_string(index + 1);
        if (box.low.x == box.high.x || box.low.y == box.high.y) {
            warn(obstacle + " has no area");
        } else if (corners == ideal) {
            return;
        } else if (std::is_permutation(corners.begin(), corners.end(), ideal.begin())) {
            warn(obstacle + ": corners are not counter-clockwise from the lower left; " +
                 "their bounding box is the obstacle");
        } else if (std::all_of(corners.begin(), corners.end(), is_corner)) {
            warn(obstacle + ": a corner is given twice; the bounding box is the obstacle");
        } else {
            warn(obstacle + ": corners are not those of an upright rectangle; " +
                 "their bounding box is the obstacle");
        }
    }

    void warn_about_rest(std::uint64_t obstacle_count) {
        while (scanner_.at_line_end()) scanner_.next_line();
        warn("content after the last of " + std::to_string(obstacle_count) + " obstacles ignored");
    }

    Scanner scanner_;
    ProblemFile result_;
    std::size_t unlisted_warnings_ = 0;
};

void append_point(std::string& text, const Point& point, char end) {
    append_number(text, point.x);
    text += ' ';
    append_number(text, point.y);
    text += end;
}

void append_positions(std::string& text, const std::vector<Point>& positions) {
    for (const Point& point : positions) append_point(text, point, ' ');
    text.back() = '\n';
}

}  // namespace

ProblemFile parse_problem(std::string_view text, const std::string& name) {
    return ProblemReader(text, name).read();
}

ProblemFile read_problem(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    if (is_scenario(text)) return parse_scenario(text, file.string(), file.parent_path());
    return parse_problem(text, file.string());
}

void write_problem(const std::filesystem::path& file, const core::Problem& problem) {
    std::string text = std::to_string(problem.asv_count()) + '\n';
    append_positions(text, problem.start);
    append_positions(text, problem.goal);
    text += std::to_string(problem.obstacles.size()) + '\n';
    for (const Box& box : problem.obstacles) {
        append_point(text, box.low, ' ');
        append_point(text, {box.high.x, box.low.y}, ' ');
        append_point(text, box.high, ' ');
        append_point(text, {box.low.x, box.high.y}, '\n');
    }
    write_file(file, text);
}

}  // namespace asv::io
