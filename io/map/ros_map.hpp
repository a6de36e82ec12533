#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/primitives.hpp"
#include "io/map/occupied_greys.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// What a map.yaml of ROS (map_server, Nav2) says of the picture beside it. How occupied a pixel is
/// goes from 0 (white) to 1 (black); in a negated map from 0 (black) to 1 (white).
struct RosMap {
    std::string image;         ///< the picture, relative to the file
    double resolution = 0;     ///< side of a pixel, metres
    geometry::Point origin{};  ///< lower left corner, metres
    bool negated = false;
    double occupied_thresh = 0;     ///< a pixel that is more occupied than this is an obstacle
    double free_thresh = 0;         ///< one that is less so is free; those in between are unknown
    std::vector<Warning> warnings;  ///< of what is passed over

    /// The greys of obstacles, and with unknown also those of what is unknown.
    OccupiedGreys occupied(bool unknown) const;
};

/// Throws ParseError, also for what cannot be kept: a map that is turned, or one that holds
/// occupancies themselves (mode: raw).
RosMap parse_ros_map(std::string_view content, const std::string& name);

}  // namespace asv::io
