#pragma once

#include <memory>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"
#include "geometry/boxes/box_index.hpp"

namespace asv::geometry::benchmark_scene {

/// One world with valid chains in it, in the forms that the contenders want.
struct Scene {
    Scene(std::size_t points, std::vector<Box> given_boxes, std::size_t chain_count);

    std::size_t points;
    std::vector<Box> boxes;
    BoxIndex index;
    core::batch::ChainLimits limits;
    std::vector<std::vector<double>> chains;  ///< x, y, headings
    std::vector<geometry::simd::Pack> packs;  ///< the same, points + 1 rows for every eight chains

    struct Line {
        std::vector<double> from, step;
    };
    /// Valid motions towards another chain, on which some point moves by 0.1: edges of a tree.
    std::vector<Line> lines;

  private:
    void add_lines();
};

/// A bound on how far any point moves on the line.
double greatest_motion(const Scene::Line& line, double link);

/// Checks chains or lines and counts the valid ones.
class Contender {
  public:
    virtual ~Contender() = default;
    /// How many of the first count are valid. Precondition: count is a multiple of eight.
    virtual std::size_t count_valid(std::size_t count) = 0;
};

std::unique_ptr<Contender> make_kernel(const Scene& scene);
std::unique_ptr<Contender> make_scalar(const Scene& scene);
/// These replace the collision test of the scalar loop by another library's.
std::unique_ptr<Contender> make_cgal(const Scene& scene);
std::unique_ptr<Contender> make_boost(const Scene& scene);

/// Proves the lines of the scene valid.
std::unique_ptr<Contender> make_line_kernel(const Scene& scene);
/// Goes along them in steps in which no point moves more than 0.001, by the scalar state check.
std::unique_ptr<Contender> make_line_scalar(const Scene& scene);

}  // namespace asv::geometry::benchmark_scene
