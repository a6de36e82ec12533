#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/benchmark/scene.hpp"

namespace asv::geometry::benchmark_scene {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class Cgal : public Contender {
  public:
    explicit Cgal(const Scene& scene) : scene_(scene), points_(scene.points) {
        for (const Box& box : scene.boxes) {
            boxes_.emplace_back(Kernel::Point_2(box.low.x, box.low.y),
                                Kernel::Point_2(box.high.x, box.high.y));
        }
    }

    std::size_t count_valid(std::size_t count) override {
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count; ++i) {
            core::reference::positions(scene_.chains[i], scene_.limits.link, points_);
            valid +=
                core::reference::shape_valid(scene_.chains[i], points_, scene_.limits) && free();
        }
        return valid;
    }

  private:
    bool free() const {
        for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
            const Kernel::Segment_2 link(Kernel::Point_2(points_[k].x, points_[k].y),
                                         Kernel::Point_2(points_[k + 1].x, points_[k + 1].y));
            for (const Kernel::Iso_rectangle_2& box : boxes_) {
                if (CGAL::do_intersect(link, box)) return false;
            }
        }
        return true;
    }

    const Scene& scene_;
    std::vector<Point> points_;
    std::vector<Kernel::Iso_rectangle_2> boxes_;
};

}  // namespace

std::unique_ptr<Contender> make_cgal(const Scene& scene) {
    return std::make_unique<Cgal>(scene);
}

}  // namespace asv::geometry::benchmark_scene
