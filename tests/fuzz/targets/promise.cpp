#include "tests/fuzz/targets/promise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

namespace asv::fuzz {

namespace {

bool all_finite(std::span<const geometry::Point> points) {
    return std::all_of(points.begin(), points.end(), [](const geometry::Point& point) {
        return std::isfinite(point.x) && std::isfinite(point.y);
    });
}

}  // namespace

void require(bool kept, std::string_view promise) {
    if (!kept) throw std::logic_error(std::string(promise));
}

void require_place_in(std::string_view text, const io::ParseError& error) {
    const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
    const auto line_ends = std::count_if(text.begin(), text.end(), ends_line);
    require(error.line() >= 1 && error.line() <= static_cast<std::size_t>(line_ends) + 1,
            "an error names a line of the text");
    require(error.column() >= 1 && error.column() <= text.size() + 1,
            "an error names a column of the text");
}

void require_sound(const core::Problem& problem) {
    require(problem.asv_count() >= 1, "a problem has an ASV");
    require(problem.goal.size() == problem.asv_count(), "a goal has as many ASVs as the start");
    require(all_finite(problem.start) && all_finite(problem.goal), "start and goal are finite");
    for (const geometry::Box& box : problem.obstacles) {
        require(!geometry::is_empty(box), "no obstacle is empty");
        require(all_finite(std::array{box.low, box.high}), "obstacles are finite");
    }
}

}  // namespace asv::fuzz
