#include "tests/benchmark/scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/batch/line_check.hpp"

namespace asv::geometry::benchmark_scene {

Scene::Scene(std::size_t given_points, std::vector<Box> given_boxes, std::size_t chain_count)
    : points(given_points),
      boxes(std::move(given_boxes)),
      index(boxes),
      limits(test::chain_limits(points)) {
    test::Random random(points);
    chains = test::valid_chains(points, chain_count, boxes, random);
    chains.resize(chains.size() / geometry::simd::lanes * geometry::simd::lanes);
    const std::size_t rows = points + 1;
    packs.resize(chains.size() / geometry::simd::lanes * rows);
    for (std::size_t i = 0; i < chains.size(); ++i) {
        for (std::size_t k = 0; k < rows; ++k) {
            packs[i / geometry::simd::lanes * rows + k][i % geometry::simd::lanes] = chains[i][k];
        }
    }
    add_lines();
}

void Scene::add_lines() {
    constexpr double motion = 0.1, resolution = 1e-6;
    core::batch::ChainBatch batch(points - 1, limits, index);
    test::LineCheck check(batch);
    for (std::size_t i = 1; i < chains.size(); ++i) {
        Line line{chains[i - 1], chains[i]};
        for (std::size_t k = 0; k < line.step.size(); ++k) line.step[k] -= line.from[k];
        const double scale = motion / greatest_motion(line, limits.link);
        for (double& change : line.step) change *= std::min(scale, 1.0);
        if (check.valid(line.from, line.step, resolution)) lines.push_back(line);
    }
    lines.resize(lines.size() / geometry::simd::lanes * geometry::simd::lanes);
}

double greatest_motion(const Scene::Line& line, double link) {
    double reach = std::hypot(line.step[0], line.step[1]), greatest = reach;
    for (std::size_t k = 2; k < line.step.size(); ++k) {
        reach += link * std::fabs(line.step[k]);
        greatest = std::max(greatest, reach);
    }
    return greatest;
}

namespace {

class Kernel : public Contender {
  public:
    explicit Kernel(const Scene& scene)
        : scene_(scene), batch_(scene.points - 1, scene.limits, scene.index) {}

    std::size_t count_valid(std::size_t count) override {
        const std::size_t rows = scene_.points + 1;
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count / geometry::simd::lanes; ++i) {
            const auto pack = std::span(scene_.packs).subspan(i * rows, rows);
            valid += static_cast<std::size_t>(std::popcount(batch_.valid(pack)));
        }
        return valid;
    }

  private:
    const Scene& scene_;
    core::batch::ChainBatch batch_;
};

class Scalar : public Contender {
  public:
    explicit Scalar(const Scene& scene) : scene_(scene), points_(scene.points) {}

    std::size_t count_valid(std::size_t count) override {
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count; ++i) {
            valid += core::reference::valid(scene_.chains[i], scene_.limits, scene_.boxes, points_);
        }
        return valid;
    }

  private:
    const Scene& scene_;
    std::vector<Point> points_;
};

class LineKernel : public Contender {
  public:
    explicit LineKernel(const Scene& scene)
        : scene_(scene), batch_(scene.points - 1, scene.limits, scene.index), check_(batch_) {}

    std::size_t count_valid(std::size_t count) override {
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count; ++i) {
            valid += check_.valid(scene_.lines[i].from, scene_.lines[i].step, 1e-6);
        }
        return valid;
    }

  private:
    const Scene& scene_;
    core::batch::ChainBatch batch_;
    test::LineCheck check_;
};

class LineScalar : public Contender {
  public:
    explicit LineScalar(const Scene& scene)
        : scene_(scene), row_(scene.points + 1), points_(scene.points) {}

    std::size_t count_valid(std::size_t count) override {
        std::size_t valid = 0;
        for (std::size_t i = 0; i < count; ++i) valid += is_valid(scene_.lines[i]);
        return valid;
    }

  private:
    bool is_valid(const Scene::Line& line) {
        const double steps = std::ceil(greatest_motion(line, scene_.limits.link) / 0.001);
        for (double i = 0; i <= steps; ++i) {
            for (std::size_t k = 0; k < row_.size(); ++k) {
                row_[k] = line.from[k] + i / steps * line.step[k];
            }
            if (!core::reference::valid(row_, scene_.limits, scene_.boxes, points_)) return false;
        }
        return true;
    }

    const Scene& scene_;
    std::vector<double> row_;
    std::vector<Point> points_;
};

}  // namespace

std::unique_ptr<Contender> make_kernel(const Scene& scene) {
    return std::make_unique<Kernel>(scene);
}

std::unique_ptr<Contender> make_scalar(const Scene& scene) {
    return std::make_unique<Scalar>(scene);
}

std::unique_ptr<Contender> make_line_kernel(const Scene& scene) {
    return std::make_unique<LineKernel>(scene);
}

std::unique_ptr<Contender> make_line_scalar(const Scene& scene) {
    return std::make_unique<LineScalar>(scene);
}

}  // namespace asv::geometry::benchmark_scene
