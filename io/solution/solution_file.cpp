#include "io/solution/solution_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "io/text/atomic_file.hpp"
#include "io/text/number_text.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {
namespace {

using geometry::Point;

struct Header {
    std::uint64_t steps;
    double cost;
};

Header read_header(Scanner& scanner) {
    const std::optional<std::uint64_t> steps = scanner.count(0);
    if (!steps) throw scanner.error("the number of primitive steps (a whole number, at least 0)");
    const double cost =
        scanner.require_number([] { return std::string("a number (the total cost)"); });
    if (!scanner.at_line_end()) throw scanner.error("nothing more on this line");
    scanner.next_line();
    return {*steps, cost};
}

void read_state(Scanner& scanner, std::uint64_t index, std::vector<Point>& state) {
    const auto expected = [&](char axis, std::size_t asv) {
        return std::string("a number (") + axis + " of ASV " + std::to_string(asv + 1) +
               " in state " + std::to_string(index) + ")";
    };
    for (std::size_t i = 0; i < state.size(); ++i) {
        state[i].x = scanner.require_number([&] { return expected('x', i); });
        state[i].y = scanner.require_number([&] { return expected('y', i); });
    }
    if (!scanner.at_line_end()) {
        throw scanner.error("the end of the line after " + std::to_string(state.size()) +
                            " positions");
    }
    scanner.next_line();
}

}  // namespace

core::Solution parse_solution(std::string_view text, std::size_t asv_count,
                              const std::string& name) {
    if (asv_count == 0) throw std::invalid_argument("parse_solution: asv_count is 0");
    Scanner scanner(text, name);
    const auto [steps, cost] = read_header(scanner);
    core::Solution solution{core::Path(asv_count), cost};
    // A position takes at least four characters, so that a false count reserves no more than the
    // text can fill.
    const std::size_t max_states = text.size() / asv_count / 4 + 1;
    solution.path.reserve(std::min<std::uint64_t>(steps, max_states) + 1);
    std::vector<Point> state(asv_count);
    for (std::uint64_t i = 0; i <= steps; ++i) {
        if (scanner.at_end()) {
            throw scanner.error("state " + std::to_string(i) + " of 0 to " + std::to_string(steps));
        }
        read_state(scanner, i, state);
        solution.path.push_back(state);
    }
    if (!scanner.at_end()) {
        throw scanner.error("the end of the file after " + std::to_string(steps) +
                            " primitive steps");
    }
    return solution;
}

core::Solution read_solution(const std::filesystem::path& file, std::size_t asv_count) {
    return parse_solution(read_file(file), asv_count, file.string());
}

void write_solution(const std::filesystem::path& file, const core::Solution& solution) {
    if (solution.path.empty()) throw std::invalid_argument("write_solution: the path is empty");
    std::string text = std::to_string(solution.path.size() - 1) + ' ';
    append_number(text, solution.cost);
    for (std::size_t i = 0; i < solution.path.size(); ++i) {
        char separator = '\n';
        for (const Point& point : solution.path.state(i)) {
            text += separator;
            append_number(text, point.x);
            text += ' ';
            append_number(text, point.y);
            separator = ' ';
        }
    }
    text += '\n';
    write_file(file, text);
}

}  // namespace asv::io
