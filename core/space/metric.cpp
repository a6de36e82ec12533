#include "core/space/metric.hpp"

#include <cmath>

namespace asv::core {

Metric::Metric(const Chain& chain, std::span<const std::vector<geometry::Point>> shapes)
    : scale_(chain.dimension(), 0.0) {
    scale_[0] = scale_[1] = 1;
    if (chain.asv_count() < 2) return;
    Pose pose = chain.make_pose();
    std::vector<double> row(chain.dimension()), unit(chain.dimension()), rate(chain.broom_count());
    const double length = chain.broom_length();
    for (const auto& shape : shapes) {
        chain.configuration(shape, row);
        chain.forward(row, pose);
        for (std::size_t i = 2; i < chain.dimension(); ++i) {
            unit.assign(unit.size(), 0.0);
            unit[i] = 1;
            chain.headings(unit, rate);
            for (std::size_t j = 0; j < chain.asv_count(); ++j) {
                double vx = 0, vy = 0;
                for (std::size_t k = 0; k < chain.broom_count(); ++k) {
                    const double pull = length * chain.lever(j, 0, k) * rate[k];
                    vx -= pull * pose.uy[k];
                    vy += pull * pose.ux[k];
                }
                scale_[i] += vx * vx + vy * vy;
            }
        }
    }
    const auto count = static_cast<double>(shapes.size() * chain.asv_count());
    for (std::size_t i = 2; i < scale_.size(); ++i) scale_[i] = std::sqrt(scale_[i] / count);
}

double Metric::distance(std::span<const double> a, std::span<const double> b) const {
    double sum = 0;
    for (std::size_t i = 0; i < scale_.size(); ++i) {
        const double d = scale_[i] * (a[i] - b[i]);
        sum += d * d;
    }
    return std::sqrt(sum);
}

}  // namespace asv::core
