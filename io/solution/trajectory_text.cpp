#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/trajectory/time_optimal.hpp"
#include "geometry/elementary/functions.hpp"
#include "io/solution/trajectory_file.hpp"
#include "io/solution/trajectory_header.hpp"
#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

using core::Trajectory;
using core::VehicleMotion;
using geometry::Point;

/// A name of ROS for a fixed frame (REP 105).
constexpr const char* frame = "map";

class TrajectoryWriter {
  public:
    explicit TrajectoryWriter(const Trajectory& trajectory)
        : trajectory_(trajectory), motions_(core::vehicle_motions(trajectory)) {}

    std::string csv() && {
        text_ = csv_header(vehicles()) + '\n';
        for (std::size_t k = 0; k < trajectory_.size(); ++k) {
            number(trajectory_.times[k]);
            for (std::size_t i = 0; i < vehicles(); ++i) {
                const VehicleMotion& moving = motion(k, i);
                for (const double value :
                     {place(k, i).x, place(k, i).y, moving.heading, moving.speed}) {
                    text_ += ',';
                    number(value);
                }
            }
            text_ += '\n';
        }
        return std::move(text_);
    }

    std::string json() && {
        text_ = "{\"version\": " + std::to_string(trajectory_version) +
                ", \"asv_count\": " + std::to_string(vehicles()) + ", \"duration\": ";
        number(trajectory_.duration());
        text_ += ", \"samples\": [";
        for (std::size_t k = 0; k < trajectory_.size(); ++k) {
            text_ += k == 0 ? "\n{\"time\":" : ",\n{\"time\":";
            number(trajectory_.times[k]);
            list(",\"positions\":[", [&](std::size_t i) {
                text_ += '[';
                number(place(k, i).x);
                text_ += ',';
                number(place(k, i).y);
                text_ += ']';
            });
            list(",\"headings\":[", [&](std::size_t i) { number(motion(k, i).heading); });
            list(",\"speeds\":[", [&](std::size_t i) { number(motion(k, i).speed); });
            text_ += '}';
        }
        text_ += "\n]}\n";
        return std::move(text_);
    }

    std::string yaml() && {
        for (std::size_t i = 0; i < vehicles(); ++i) {
            text_ += "---\n# nav_msgs/Path of vehicle " + std::to_string(i + 1) + " of " +
                     std::to_string(vehicles()) + "\nheader: ";
            header(0);
            text_ += "\nposes:\n";
            for (std::size_t k = 0; k < trajectory_.size(); ++k) pose(k, i);
        }
        return std::move(text_);
    }

  private:
    std::size_t vehicles() const { return trajectory_.states.asv_count(); }
    const Point& place(std::size_t k, std::size_t i) const {
        return trajectory_.states.state(k)[i];
    }
    const VehicleMotion& motion(std::size_t k, std::size_t i) const {
        return motions_[k * vehicles() + i];
    }

    void number(double value) { append_number(text_, value); }

    void whole(std::int64_t value) {
        std::array<char, 24> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        text_.append(digits.data(), end);
    }

    /// With a point, without which YAML 1.1 takes "1e-05" for a text and "1" for a whole number.
    void number_with_point(double value) {
        const std::size_t begin = text_.size();
        number(value);
        if (text_.find('.', begin) != std::string::npos) return;
        const std::size_t exponent = text_.find('e', begin);
        text_.insert(exponent == std::string::npos ? text_.size() : exponent, ".0");
    }

    template <class Append>
    void list(const char* begin, const Append& append) {
        text_ += begin;
        for (std::size_t i = 0; i < vehicles(); ++i) {
            if (i > 0) text_ += ',';
            append(i);
        }
        text_ += ']';
    }

    void header(std::size_t k) {
        constexpr double nanoseconds = 1e9;
        const double time = trajectory_.times[k] - trajectory_.times[0];
        auto seconds = static_cast<std::int64_t>(time);
        auto rest = std::llround((time - static_cast<double>(seconds)) * nanoseconds);
        if (rest == static_cast<std::int64_t>(nanoseconds)) {
            ++seconds;
            rest = 0;
        }
        text_ += "{stamp: {sec: ";
        whole(seconds);
        text_ += ", nanosec: ";
        whole(rest);
        text_.append("}, frame_id: ").append(frame).append("}");
    }

    void pose(std::size_t k, std::size_t i) {
        const double half = motion(k, i).heading / 2;
        text_ += "- {header: ";
        header(k);
        text_ += ", pose: {position: {x: ";
        number_with_point(place(k, i).x);
        text_ += ", y: ";
        number_with_point(place(k, i).y);
        text_ += ", z: 0.0}, orientation: {x: 0.0, y: 0.0, z: ";
        number_with_point(elementary::sin(half));
        text_ += ", w: ";
        number_with_point(elementary::cos(half));
        text_ += "}}}\n";
    }

    const Trajectory& trajectory_;
    std::vector<VehicleMotion> motions_;
    std::string text_;
};

}  // namespace

std::string csv_header(std::size_t vehicles) {
    std::string names = "time";
    for (std::size_t i = 1; i <= vehicles; ++i)
        for (const char* name : {",x", ",y", ",heading", ",speed"})
            names += name + std::to_string(i);
    return names;
}

std::string format_trajectory(const Trajectory& trajectory, TrajectoryFormat format) {
    TrajectoryWriter writer(trajectory);
    switch (format) {
        case TrajectoryFormat::csv:
            return std::move(writer).csv();
        case TrajectoryFormat::json:
            return std::move(writer).json();
        case TrajectoryFormat::yaml:
            break;
    }
    return std::move(writer).yaml();
}

}  // namespace asv::io
