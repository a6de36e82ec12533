#include "core/shorten/band/way_points.hpp"

namespace asv::core {

Configurations resampled(const Configurations& path, const Metric& metric, double spacing) {
    const std::size_t d = metric.dimension();
    Configurations rows(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(d));
    for (std::size_t i = d; i < path.size(); i += d) {
        const double* a = path.data() + i - d;
        const double* b = path.data() + i;
        const double length = metric.distance({a, d}, {b, d});
        const auto pieces = static_cast<std::size_t>(length / spacing) + 1;
        for (std::size_t piece = 1; piece < pieces; ++piece) {
            const double t = static_cast<double>(piece) / static_cast<double>(pieces);
            for (std::size_t k = 0; k < d; ++k) rows.push_back(a[k] + t * (b[k] - a[k]));
        }
        rows.insert(rows.end(), b, b + d);
    }
    return rows;
}

}  // namespace asv::core
