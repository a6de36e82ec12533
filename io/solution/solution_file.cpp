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

class SolutionReader {
  public:
    SolutionReader(std::string_view text, std::size_t asv_count, const std::string& name)
        : scanner_(text, name), asv_count_(asv_count), bytes_(text.size()) {}

    core::Solution read() {
        const std::size_t steps = read_steps();
        const double cost =
            scanner_.require_number([] { return std::string("a number (the total cost)"); });
        scanner_.leave_line([] { return std::string("the total cost"); });
        core::Solution solution{core::Path(asv_count_), cost};
        // A position takes at least four characters, so that a false count reserves no more than
        // the text can fill.
        solution.path.reserve(std::min(steps, bytes_ / asv_count_ / 4 + 1) + 1);
        std::vector<Point> state(asv_count_);
        for (std::size_t i = 0; i <= steps; ++i) {
            if (scanner_.at_end()) {
                throw scanner_.error("state " + std::to_string(i) + " of 0 to " +
                                     std::to_string(steps));
            }
            read_state(i, state);
            solution.path.push_back(state);
        }
        if (!scanner_.at_end()) warn_about_rest(steps);
        return solution;
    }

    void take_warnings(std::vector<Warning>& all) {
        std::vector<Warning> found = scanner_.take_warnings();
        if (surplus_lines_ > 1) {
            for (Warning& warning : found)
                if (warning.line == first_surplus_line_ &&
                    warning.message.starts_with("ignored after"))
                    warning.message +=
                        " (and so on " + std::to_string(surplus_lines_ - 1) + " further lines)";
        }
        all.insert(all.end(), found.begin(), found.end());
    }

  private:
    std::size_t read_steps() {
        const std::size_t most = max_path_positions / asv_count_ - 1;
        const std::optional<std::uint64_t> steps = scanner_.count(0, most);
        if (!steps)
            throw scanner_.error("the number of primitive steps (a whole number from 0 to " +
                                 std::to_string(most) + ")");
        return static_cast<std::size_t>(*steps);
    }

    void read_state(std::size_t index, std::vector<Point>& state) {
        const auto expected = [&](char axis, std::size_t asv) {
            return std::string("a number (") + axis + " of ASV " + std::to_string(asv + 1) +
                   " in state " + std::to_string(index) + ")";
        };
        for (std::size_t i = 0; i < state.size(); ++i) {
            state[i].x = scanner_.require_number([&] { return expected('x', i); });
            state[i].y = scanner_.require_number([&] { return expected('y', i); });
        }
        leave_state();
    }

    /// Where every line has a number too many, one warning tells of all.
    void leave_state() {
        if (scanner_.at_line_end() || surplus_lines_++ > 0) return scanner_.next_line();
        first_surplus_line_ = scanner_.line();
        scanner_.leave_line(
            [&] { return "ASV " + std::to_string(asv_count_) + ", the last one of a state"; });
    }

    void warn_about_rest(std::size_t steps) {
        while (scanner_.at_line_end()) scanner_.next_line();
        scanner_.warn("ignored: what follows state " + std::to_string(steps) + ", the last one");
    }

    Scanner scanner_;
    std::size_t asv_count_;
    std::size_t bytes_;
    std::size_t surplus_lines_ = 0;
    std::size_t first_surplus_line_ = 0;
};

}  // namespace

core::Solution parse_solution(std::string_view text, std::size_t asv_count, const std::string& name,
                              std::vector<Warning>* warnings) {
    if (asv_count == 0 || asv_count > max_path_positions)
        throw std::invalid_argument("parse_solution: no such number of ASVs");
    SolutionReader reader(text, asv_count, name);
    core::Solution solution = reader.read();
    if (warnings != nullptr) reader.take_warnings(*warnings);
    return solution;
}

core::Solution read_solution(const std::filesystem::path& file, std::size_t asv_count,
                             std::vector<Warning>* warnings) {
    return parse_solution(read_file(file), asv_count, input_name(file), warnings);
}

std::string format_solution(const core::Solution& solution) {
    if (solution.path.empty()) throw std::invalid_argument("format_solution: the path is empty");
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
    return text;
}

void write_solution(const std::filesystem::path& file, const core::Solution& solution) {
    write_file(file, format_solution(solution));
}

}  // namespace asv::io
