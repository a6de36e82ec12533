#include "io/solution/trajectory_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "io/solution/solution_file.hpp"
#include "io/solution/trajectory_header.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/json/document.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

using core::Trajectory;
using geometry::Point;
using Json = JsonDocument::Json;
using Pointer = JsonDocument::Pointer;

/// Of a line that is not understood, in a message.
constexpr std::size_t longest_shown = 40;

bool is_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

void require_header(std::string_view text, std::size_t asv_count, const std::string& name) {
    std::string_view line = text.substr(0, text.find('\n'));
    while (line.ends_with('\r')) line.remove_suffix(1);
    const std::string wanted = csv_header(asv_count);
    if (line == wanted) return;
    const auto differing =
        std::mismatch(line.begin(), line.end(), wanted.begin(), wanted.end()).first;
    std::string shown(line.substr(0, longest_shown));
    if (line.size() > longest_shown) shown += "...";
    throw ParseError(name, 1, static_cast<std::size_t>(differing - line.begin()) + 1,
                     "a trajectory of " + std::to_string(asv_count) +
                         (asv_count == 1 ? " vehicle" : " vehicles") +
                         ": JSON, or CSV with the columns time,x1,y1,heading1,speed1,...",
                     text.empty() ? "end of file" : "'" + shown + "'");
}

class CsvReader {
  public:
    /// text: commas are blanks in it, so that every number stays where it was.
    CsvReader(std::string_view text, std::size_t asv_count, const std::string& name)
        : scanner_(text, name), asv_count_(asv_count) {}

    TrajectoryFile read() {
        scanner_.next_line();
        TrajectoryFile file{{core::Path(asv_count_), {}}, scanner_.line()};
        const std::size_t most = max_path_positions / asv_count_;
        std::vector<Point> state(asv_count_);
        while (!scanner_.at_end()) {
            if (file.trajectory.size() == most)
                throw scanner_.error("at most " + std::to_string(most) + " samples");
            file.trajectory.times.push_back(value("time", 0));
            for (std::size_t i = 0; i < asv_count_; ++i) {
                state[i] = {value("x", i), value("y", i)};
                value("heading", i);
                value("speed", i);
            }
            if (!scanner_.at_line_end())
                throw scanner_.error("the end of the line behind the speed of vehicle " +
                                     std::to_string(asv_count_));
            file.trajectory.states.push_back(state);
            scanner_.next_line();
        }
        if (file.trajectory.times.empty()) throw scanner_.error("a sample");
        return file;
    }

  private:
    double value(const char* what, std::size_t vehicle) {
        return scanner_.require_number([&] {
            const std::string number = std::string("a number (") + what;
            return *what == 't' ? number + ")"
                                : number + " of vehicle " + std::to_string(vehicle + 1) + ")";
        });
    }

    Scanner scanner_;
    std::size_t asv_count_;
};

TrajectoryFile parse_csv(std::string_view text, std::size_t asv_count, const std::string& name) {
    require_header(text, asv_count, name);
    std::string blanks(text);
    std::replace(blanks.begin(), blanks.end(), ',', ' ');
    return CsvReader(blanks, asv_count, name).read();
}

bool is_coordinate(const Json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= largest_number;
}

bool is_point(const Json& value) {
    return value.is_array() && value.size() == 2 && is_coordinate(value[0]) &&
           is_coordinate(value[1]);
}

void append_sample(const JsonDocument& document, const Pointer& at, std::vector<Point>& state,
                   Trajectory& trajectory) {
    trajectory.times.push_back(document.number(at / "time", -largest_number, largest_number));
    const Json& positions = document.array(at / "positions");
    if (positions.size() != state.size())
        document.fail(at / "positions", "an array of " + std::to_string(state.size()) +
                                            " points [x, y], one for each vehicle");
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (!is_point(positions[i])) document.fail(at / "positions" / i, "a point [x, y]");
        state[i] = {positions[i][0].get<double>(), positions[i][1].get<double>()};
    }
    trajectory.states.push_back(state);
}

TrajectoryFile parse_json(std::string_view text, std::size_t asv_count, const std::string& name) {
    const JsonDocument document(text, name);
    document.integer(Pointer("/version"), trajectory_version, trajectory_version);
    const auto count = static_cast<std::int64_t>(asv_count);
    document.integer(Pointer("/asv_count"), count, count);
    const Pointer samples("/samples");
    const std::size_t size = document.array(samples).size();
    if (size == 0) document.fail(samples, "at least one sample");
    if (size > max_path_positions / asv_count)
        document.fail(samples,
                      "at most " + std::to_string(max_path_positions / asv_count) + " samples");
    TrajectoryFile file{{core::Path(asv_count), {}}, {}};
    std::vector<Point> state(asv_count);
    for (std::size_t k = 0; k < size; ++k)
        append_sample(document, samples / k, state, file.trajectory);
    const std::size_t first = document.place(samples / 0).line;
    if (document.place(samples / (size - 1)).line == first + size - 1) file.first_line = first;
    return file;
}

}  // namespace

std::optional<TrajectoryFormat> trajectory_format(const std::filesystem::path& file) {
    const std::filesystem::path ending = file.extension();
    if (file == standard_stream || ending == ".csv") return TrajectoryFormat::csv;
    if (ending == ".json") return TrajectoryFormat::json;
    if (ending == ".yaml" || ending == ".yml") return TrajectoryFormat::yaml;
    return std::nullopt;
}

void write_trajectory(const std::filesystem::path& file, const Trajectory& trajectory,
                      TrajectoryFormat format) {
    if (format == TrajectoryFormat::yaml && trajectory.duration() > longest_yaml)
        throw WriteError(output_name(file) +
                         ": the trajectory takes longer than the 2147483647 s that a stamp of ROS "
                         "holds; .csv and .json hold any time");
    write_file(file, format_trajectory(trajectory, format));
}

TrajectoryFile parse_trajectory(std::string_view text, std::size_t asv_count,
                                const std::string& name) {
    if (asv_count == 0 || asv_count > max_path_positions)
        throw std::invalid_argument("parse_trajectory: no such number of vehicles");
    return is_json(text) ? parse_json(text, asv_count, name) : parse_csv(text, asv_count, name);
}

TrajectoryFile read_trajectory(const std::filesystem::path& file, std::size_t asv_count) {
    return parse_trajectory(read_file(file), asv_count, input_name(file));
}

}  // namespace asv::io
