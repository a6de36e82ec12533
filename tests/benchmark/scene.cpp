#include "scene.hpp"

#include <bit>

#include "scalar_chain.hpp"
#include "worlds.hpp"

namespace asv::geometry::benchmark_scene {

Scene::Scene(std::size_t given_points, std::vector<Box> given_boxes, std::size_t chain_count)
    : points(given_points),
      boxes(std::move(given_boxes)),
      index(boxes),
      limits(benchmark_worlds::chain_limits(points)) {
    benchmark_worlds::Random random(points);
    chains = benchmark_worlds::valid_chains(points, chain_count, boxes, random);
    chains.resize(chains.size() / batch::lanes * batch::lanes);
    const std::size_t rows = points + 1;
    packs.resize(chains.size() / batch::lanes * rows);
    for (std::size_t i = 0; i < chains.size(); ++i) {
        for (std::size_t k = 0; k < rows; ++k) {
            packs[i / batch::lanes * rows + k][i % batch::lanes] = chains[i][k];
        }
    }
}

namespace {

class Kernel : public Contender {
  public:
    explicit Kernel(const Scene& scene)
        : scene_(scene), batch_(scene.points - 1, scene.limits, scene.index) {}

    std::size_t count_valid(std::size_t count) override {
        const std::size_t rows = scene_.points + 1;
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count / batch::lanes; ++i) {
            const auto pack = std::span(scene_.packs).subspan(i * rows, rows);
            valid += static_cast<std::size_t>(std::popcount(batch_.valid(pack)));
        }
        return valid;
    }

  private:
    const Scene& scene_;
    batch::ChainBatch batch_;
};

class Scalar : public Contender {
  public:
    explicit Scalar(const Scene& scene) : scene_(scene), points_(scene.points) {}

    std::size_t count_valid(std::size_t count) override {
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count; ++i) {
            valid += reference::valid(scene_.chains[i], scene_.limits, scene_.boxes, points_);
        }
        return valid;
    }

  private:
    const Scene& scene_;
    std::vector<Point> points_;
};

}  // namespace

std::unique_ptr<Contender> make_kernel(const Scene& scene) {
    return std::make_unique<Kernel>(scene);
}

std::unique_ptr<Contender> make_scalar(const Scene& scene) {
    return std::make_unique<Scalar>(scene);
}

}  // namespace asv::geometry::benchmark_scene
