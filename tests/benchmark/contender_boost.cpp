#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/benchmark/scene.hpp"

namespace asv::geometry::benchmark_scene {

namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;

class Boost : public Contender {
  public:
    explicit Boost(const Scene& scene) : scene_(scene), points_(scene.points) {
        for (const Box& box : scene.boxes) {
            boxes_.emplace_back(BoostPoint(box.low.x, box.low.y),
                                BoostPoint(box.high.x, box.high.y));
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
            const bg::model::segment<BoostPoint> link(
                BoostPoint(points_[k].x, points_[k].y),
                BoostPoint(points_[k + 1].x, points_[k + 1].y));
            for (const auto& box : boxes_) {
                if (bg::intersects(link, box)) return false;
            }
        }
        return true;
    }

    const Scene& scene_;
    std::vector<Point> points_;
    std::vector<bg::model::box<BoostPoint>> boxes_;
};

}  // namespace

std::unique_ptr<Contender> make_boost(const Scene& scene) {
    return std::make_unique<Boost>(scene);
}

}  // namespace asv::geometry::benchmark_scene
