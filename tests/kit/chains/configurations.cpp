#include "tests/kit/chains/configurations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asv::test {

Row row_of(const core::Chain& chain, const Points& positions) {
    Row row(chain.dimension());
    chain.configuration(positions, row);
    return row;
}

Points positions_of(const core::Chain& chain, std::span<const double> row) {
    const std::size_t n = chain.asv_count();
    std::vector<double> heading(chain.broom_count());
    double mean = 0;
    for (std::size_t k = 0; k < heading.size(); ++k) {
        heading[k] = k == 0 ? row[2] : heading[k - 1] + row[2 + k];
        mean += heading[k] / static_cast<double>(heading.size());
    }
    if (chain.anchor() == core::Anchor::centroid)
        for (double& h : heading) h += row[2] - mean;
    Points points{{0, 0}};
    for (const double h : heading) {
        const Point& last = points.back();
        points.push_back({last.x + chain.broom_length() * std::cos(h),
                          last.y + chain.broom_length() * std::sin(h)});
    }
    Point anchor{0, 0};
    if (chain.anchor() == core::Anchor::centroid)
        for (const Point& p : points)
            anchor = {anchor.x + p.x / static_cast<double>(n),
                      anchor.y + p.y / static_cast<double>(n)};
    return moved(std::move(points), row[0] - anchor.x, row[1] - anchor.y);
}

Row between(std::span<const double> a, std::span<const double> b, double t) {
    Row row(a.begin(), a.end());
    for (std::size_t i = 0; i < row.size(); ++i) row[i] += t * (b[i] - a[i]);
    return row;
}

Row moved_by(const core::Chain& chain, std::span<const double> row, std::span<const double> step) {
    Row out(row.begin(), row.end());
    for (std::size_t k = 0; k < std::min<std::size_t>(out.size(), 3); ++k) out[k] += step[k];
    for (std::size_t t = 0; t < chain.turn_count(); ++t) {
        const double turn = step[3 + t] - step[2 + t];
        out[2] += chain.heading_share()[t] * turn;
        out[3 + t] += turn;
    }
    return out;
}

double along(const core::Chain& chain, const core::Configurations& rows, int pieces,
             const std::function<double(const Points& before, const Points& after)>& measure) {
    const std::size_t d = chain.dimension();
    double sum = 0;
    for (std::size_t i = 1; i < rows.size() / d; ++i) {
        const auto from = nth(rows, d, i - 1), to = nth(rows, d, i);
        Points before = positions_of(chain, from);
        for (int k = 1; k <= pieces; ++k) {
            Points after = positions_of(chain, between(from, to, static_cast<double>(k) / pieces));
            sum += measure(before, after);
            before = std::move(after);
        }
    }
    return sum;
}

double way(const core::Chain& chain, const core::Configurations& rows) {
    return along(chain, rows, 100, [](const Points& before, const Points& after) {
        double sum = 0;
        for (std::size_t j = 0; j < after.size(); ++j)
            sum += std::hypot(after[j].x - before[j].x, after[j].y - before[j].y);
        return sum;
    });
}

}  // namespace asv::test
