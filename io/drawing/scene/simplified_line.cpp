#include "io/drawing/scene/simplified_line.hpp"

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/strategies/strategies.hpp>

BOOST_GEOMETRY_REGISTER_POINT_2D(asv::geometry::Point, double, boost::geometry::cs::cartesian, x, y)

namespace asv::io {

using geometry::Point;

std::vector<Point> simplified(const std::vector<Point>& points, double distance) {
    boost::geometry::model::linestring<Point> line(points.begin(), points.end());
    boost::geometry::model::linestring<Point> result;
    boost::geometry::simplify(line, result, distance);
    return {result.begin(), result.end()};
}

}  // namespace asv::io
