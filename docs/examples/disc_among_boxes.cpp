// A body of one's own: a disc among boxes, planned by RRT-Connect, and a picture of trees and path.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <span>
#include <utility>
#include <vector>

#include <asv/core/search/rrt_connect.hpp>
#include <asv/geometry/predicates/distance.hpp>
#include <asv/io/drawing/paint/canvas.hpp>

using asv::geometry::Box;
using asv::geometry::Point;
using asv::geometry::Segment;

// part: space
/// A disc in the unit square among closed boxes. A configuration is its centre.
class DiscSpace {
  public:
    DiscSpace(double radius, std::vector<Box> boxes) : radius_(radius), boxes_(std::move(boxes)) {}

    std::size_t dimension() const { return 2; }
    asv::core::WrappingAngles wrapping() const { return {}; }  // no coordinate is an angle
    asv::core::NearestNeighbours make_index() const { return {std::array{1.0, 1.0}, wrapping()}; }

    double distance(std::span<const double> a, std::span<const double> b) const {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    }

    bool sample(asv::core::Rng& rng, std::span<double> centre) const {
        centre[0] = rng.uniform(radius_, 1 - radius_);
        centre[1] = rng.uniform(radius_, 1 - radius_);
        return motion_valid(centre, centre);
    }

    /// Goes toward the target in strides, as far as they are free.
    asv::core::Steered steer(std::span<const double> from, std::span<const double> target,
                             asv::core::Configurations& visited) const {
        std::array at{from[0], from[1]};
        auto outcome = asv::core::Steered::trapped;
        while (outcome != asv::core::Steered::reached) {
            const double share = std::min(1.0, stride / distance(at, target));
            const bool last = !(share < 1);
            std::array next{target[0], target[1]};
            for (std::size_t i = 0; i < 2 && !last; ++i)
                next[i] = at[i] + share * (target[i] - at[i]);
            if (!motion_valid(at, next)) break;
            visited.insert(visited.end(), next.begin(), next.end());
            outcome = last ? asv::core::Steered::reached : asv::core::Steered::advanced;
            at = next;
        }
        return outcome;
    }

    /// The whole motion, not samples of it: the disc sweeps all that is within its radius of the
    /// way of its centre.
    bool motion_valid(std::span<const double> from, std::span<const double> to) const {
        const Segment way{{from[0], from[1]}, {to[0], to[1]}};
        for (const Box& box : boxes_)
            if (asv::geometry::distance(way, box) <= radius_) return false;
        return true;
    }

    const std::vector<Box>& boxes() const { return boxes_; }
    double radius() const { return radius_; }

  private:
    static constexpr double stride = 0.04;
    double radius_;
    std::vector<Box> boxes_;
};
static_assert(asv::core::ConfigurationSpace<DiscSpace>);
// end of part

// part: picture
/// Draws in points from the upper left; the field is a square of 560 points.
class Picture {
  public:
    Picture() : canvas_(asv::io::PictureFormat::svg, size + 2 * margin, size + 2 * margin, 1) {
        canvas_.fill_all(colours.page);
        canvas_.fill_boxes(std::array{Box{place({0, 1}), place({1, 0})}}, colours.field);
    }

    void boxes(std::span<const Box> boxes) {
        for (const Box& box : boxes) {
            const Box upside_down{place({box.low.x, box.high.y}), place({box.high.x, box.low.y})};
            canvas_.fill_boxes(std::array{upside_down}, colours.obstacle);
        }
    }

    void tree(const asv::core::Tree& tree, const asv::io::Colour& colour) {
        std::vector<Segment> edges;
        for (std::uint32_t node = 1; node < tree.size(); ++node)
            edges.push_back({place(tree.row(node)), place(tree.row(tree.parent(node)))});
        canvas_.stroke_segments(edges, {asv::io::faded(colour, 0.6), 1});
    }

    void path(const asv::core::Configurations& path, double radius) {
        std::vector<Point> centres;
        for (std::size_t i = 0; i < path.size(); i += 2)
            centres.push_back(place({path[i], path[i + 1]}));
        for (const Point& centre : centres)
            canvas_.stroke_circle(centre, radius * size, {asv::io::faded(colours.ink, 0.3), 1});
        canvas_.stroke_line(centres, {colours.ink, 2});
        canvas_.fill_circle(centres.front(), radius * size, colours.start);
        canvas_.fill_circle(centres.back(), radius * size, colours.goal);
    }

    void write(const char* file) {
        std::ofstream(file) << canvas_.finish("A disc among boxes",
                                              "Two trees, and the path that they found");
    }

    static constexpr const asv::io::Palette& colours = asv::io::light_palette;

  private:
    static Point place(const Point& p) { return {margin + size * p.x, margin + size * (1 - p.y)}; }
    static Point place(std::span<const double> row) { return place(Point{row[0], row[1]}); }

    static constexpr double size = 560, margin = 10;
    asv::io::Canvas canvas_;
};
// end of part

// part: search
int main() {
    DiscSpace space(0.03, {{{0.20, 0}, {0.30, 0.70}},
                           {{0.45, 0.35}, {0.55, 1}},
                           {{0.70, 0}, {0.80, 0.45}},
                           {{0.70, 0.53}, {0.80, 1}}});
    const std::array start{0.1, 0.1}, goal{0.9, 0.9};

    asv::core::Limits limits;
    limits.max_iterations = 10000;
    asv::core::Rng rng(1);
    const asv::core::SearchResult found =
        asv::core::rrt_connect(space, {start, goal}, asv::core::RrtConnectOptions{}, limits, rng);
    std::cout << name(found.outcome) << " after " << found.iterations << " iterations\n";
    if (found.outcome != asv::core::Outcome::solved) return 1;

    Picture picture;
    picture.boxes(space.boxes());
    picture.tree(found.trees[0], Picture::colours.start);
    picture.tree(found.trees[1], Picture::colours.goal);
    picture.path(found.path, space.radius());
    picture.write("disc.svg");
}
// end of part
