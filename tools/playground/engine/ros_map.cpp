// The map.yaml of ROS without libyaml, which is not there for WebAssembly: the page opens the
// picture alone.

#include "io/map/ros_map.hpp"

#include "io/text/parse_error.hpp"

namespace asv::io {

OccupiedGreys RosMap::occupied(bool /*unknown*/) const {
    return {};
}

RosMap parse_ros_map(std::string_view /*content*/, const std::string& name) {
    throw ParseError(name, 1, 1, "a picture or a text grid, as the playground reads them",
                     "a map.yaml");
}

}  // namespace asv::io
