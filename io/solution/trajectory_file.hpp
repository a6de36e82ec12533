#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/model/trajectory.hpp"

namespace asv::io {

/// How a trajectory is written:
///   csv    a line of names, time,x1,y1,heading1,speed1,x2,..., then a line for each sample
///   json   {"version": 1, "asv_count", "duration", "samples": [{"time", "positions", "headings",
///          "speeds"}, ...]}, a line for each sample
///   yaml   for ROS 2: a nav_msgs/Path for each vehicle, a document each, with the stamps counted
///          from the first sample, to the nearest nanosecond, in the frame "map"
/// Times are in seconds, positions in workspace units, headings in radians from the +x axis, speeds
/// in workspace units per second; core/trajectory/time_optimal.hpp says what heading and speed are.
enum class TrajectoryFormat { csv, json, yaml };

/// By the ending of the name: .csv, .json, .yaml or .yml; "-" is CSV; none for other names.
std::optional<TrajectoryFormat> trajectory_format(const std::filesystem::path& file);

/// Stamps of ROS hold no more than so many seconds.
inline constexpr double longest_yaml = 2147483647;

/// The file's text; numbers have the shortest digits that read back to the same number.
/// Precondition: at least one sample, times increase, as YAML to at most longest_yaml.
std::string format_trajectory(const core::Trajectory& trajectory, TrajectoryFormat format);

/// Writes the trajectory, whole or not at all. Throws WriteError, also where YAML cannot hold its
/// duration.
void write_trajectory(const std::filesystem::path& file, const core::Trajectory& trajectory,
                      TrajectoryFormat format);

/// A trajectory that was read. Of what a file says of headings and speeds nothing is kept.
struct TrajectoryFile {
    core::Trajectory trajectory;
    /// The line of the first sample, each of the others being on the next one; none where it is
    /// not so.
    std::optional<std::size_t> first_line;
};

/// Reads CSV or JSON, which begins with '{', of so many vehicles, with at least one sample; "-" is
/// standard input. Throws ParseError (not understood, more than max_path_positions) or ReadError.
TrajectoryFile read_trajectory(const std::filesystem::path& file, std::size_t asv_count);

/// The same from text; name stands for the file in messages.
TrajectoryFile parse_trajectory(std::string_view text, std::size_t asv_count,
                                const std::string& name);

}  // namespace asv::io
