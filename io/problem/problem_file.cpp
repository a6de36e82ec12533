#include "io/problem/problem_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/problem/scenario_file.hpp"
#include "io/problem/thin_walls.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/number_text.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {
namespace {

using geometry::Box;
using geometry::Point;

class ProblemReader {
  public:
    ProblemReader(std::string_view text, const std::string& name, const ReadOptions& options)
        : scanner_(text, name),
          bytes_(text.size()),
          tolerance_(options.tolerance.value_or(core::Requirements{}.tolerance)) {}

    ProblemFile read() {
        const std::size_t asv_count = read_count("the number of ASVs", 1, max_asvs);
        core::Problem& problem = result_.problem;
        problem.start = read_positions(asv_count, "the start");
        problem.goal = read_positions(asv_count, "the goal");
        const std::size_t obstacle_count = read_count("the number of obstacles", 0, max_obstacles);
        // The count may promise more than the file holds: an obstacle takes 16 characters.
        problem.obstacles.reserve(std::min(obstacle_count, bytes_ / 16 + 1));
        for (std::size_t i = 0; i < obstacle_count; ++i) {
            problem.obstacles.push_back(read_obstacle(i, obstacle_count));
        }
        if (!scanner_.at_end()) warn_about_rest(obstacle_count);
        result_.warnings = scanner_.take_warnings();
        return std::move(result_);
    }

  private:
    std::size_t read_count(const std::string& what, std::uint64_t least, std::uint64_t most) {
        const std::optional<std::uint64_t> count = scanner_.count(least, most);
        if (!count)
            throw scanner_.error(what + " (a whole number from " + std::to_string(least) + " to " +
                                 std::to_string(most) + ")");
        scanner_.leave_line([&] { return what; });
        return static_cast<std::size_t>(*count);
    }

    /// owner() names what the point belongs to; it is put into words only for an error.
    template <typename Owner>
    Point read_point(const Owner& owner) {
        const double x = scanner_.require_number([&] { return "a number (x of " + owner() + ")"; });
        const double y = scanner_.require_number([&] { return "a number (y of " + owner() + ")"; });
        return {x, y};
    }

    std::vector<Point> read_positions(std::size_t asv_count, const std::string& where) {
        std::vector<Point> positions;
        for (std::size_t i = 0; i < asv_count; ++i) {
            positions.push_back(
                read_point([&] { return "ASV " + std::to_string(i + 1) + " of " + where; }));
        }
        scanner_.leave_line(
            [&] { return "ASV " + std::to_string(asv_count) + ", the last one of " + where; });
        return positions;
    }

    Box read_obstacle(std::size_t index, std::size_t obstacle_count) {
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
        const Box box = geometry::bounding_box(corners);
        warn_about_corners(corners, box, index);
        scanner_.leave_line(
            [&] { return "the fourth corner of obstacle " + std::to_string(index + 1); });
        return box;
    }

    void warn_about_corners(const std::array<Point, 4>& corners, const Box& box,
                            std::size_t index) {
        const std::array<Point, 4> ideal = {box.low, Point{box.high.x, box.low.y}, box.high,
                                            Point{box.low.x, box.high.y}};
        const auto is_corner = [&](const Point& point) {
            return std::find(ideal.begin(), ideal.end(), point) != ideal.end();
        };
        const auto warn = [&](const std::string& what) {
            scanner_.warn_about_line("obstacle " + std::to_string(index + 1) + what);
        };
        if (const auto why = why_it_vanishes(box, tolerance_)) warn(" " + *why);
        if (corners == ideal) return;
        if (std::is_permutation(corners.begin(), corners.end(), ideal.begin())) {
            warn(": corners are not counter-clockwise from the lower left; " +
                 std::string("their bounding box is the obstacle"));
        } else if (std::all_of(corners.begin(), corners.end(), is_corner)) {
            warn(": a corner is given twice; the bounding box is the obstacle");
        } else {
            warn(": corners are not those of an upright rectangle; " +
                 std::string("their bounding box is the obstacle"));
        }
    }

    void warn_about_rest(std::size_t obstacle_count) {
        while (scanner_.at_line_end()) scanner_.next_line();
        scanner_.warn("ignored: what follows the last of " + std::to_string(obstacle_count) +
                      (obstacle_count == 1 ? " obstacle" : " obstacles"));
    }

    Scanner scanner_;
    std::size_t bytes_;
    double tolerance_;
    ProblemFile result_;
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

ProblemFile parse_problem(std::string_view text, const std::string& name,
                          const ReadOptions& options) {
    return ProblemReader(text, name, options).read();
}

ProblemFile read_problem(const std::filesystem::path& file, const ReadOptions& options) {
    const std::string text = read_file(file);
    if (is_scenario(text))
        return parse_scenario(text, input_name(file), file.parent_path(), options);
    return parse_problem(text, input_name(file), options);
}

std::string format_problem(const core::Problem& problem) {
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
    return text;
}

void write_problem(const std::filesystem::path& file, const core::Problem& problem) {
    write_file(file, format_problem(problem));
}

}  // namespace asv::io
