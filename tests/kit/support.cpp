#include "tests/kit/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/search/trees/interpolate.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "geometry/predicates/distance.hpp"

namespace asv::core::testing {

std::size_t scaled(std::size_t count) {
    const char* scale = std::getenv("ASV_TEST_SCALE");
    if (scale == nullptr) return count;
    const double share = static_cast<double>(count) * std::atof(scale);
    return std::max<std::size_t>(1, static_cast<std::size_t>(share));
}

Points arc(std::size_t n, Point first, double heading, double turn) {
    Points points{first};
    for (; points.size() < n; heading += turn) {
        const Point& last = points.back();
        points.push_back({last.x + 0.05 * std::cos(heading), last.y + 0.05 * std::sin(heading)});
    }
    return points;
}

Points ring(std::size_t n, Point centroid, double heading, double closing) {
    const double turn = closing * 2 * std::numbers::pi / static_cast<double>(n);
    const Points points = arc(n, {0, 0}, heading, turn);
    double x = 0, y = 0;
    for (const Point& p : points) {
        x += p.x / static_cast<double>(n);
        y += p.y / static_cast<double>(n);
    }
    return moved(points, centroid.x - x, centroid.y - y);
}

Points moved(Points points, double dx, double dy) {
    for (Point& p : points) p = {p.x + dx, p.y + dy};
    return points;
}

Points reversed(Points points) {
    std::reverse(points.begin(), points.end());
    return points;
}

Problem problem(Points start, Points goal, std::vector<Box> obstacles) {
    Problem result;
    result.start = std::move(start);
    result.goal = std::move(goal);
    result.obstacles = std::move(obstacles);
    return result;
}

std::vector<Box> clutter(Rng& rng, std::size_t count, double size, const Problem& around) {
    constexpr double room = 0.003;
    const auto meets = [&](const Points& chain, const Box& box) {
        const std::size_t last = chain.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const geometry::Segment broom{chain[i], chain[std::min(i + 1, last)]};
            if (geometry::distance(broom, box) < room) return true;
        }
        return false;
    };
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        const Point low{rng.uniform(-0.05, 1), rng.uniform(-0.05, 1)};
        const Box box{low, {low.x + rng.uniform(0.01, size), low.y + rng.uniform(0.01, size)}};
        if (!meets(around.start, box) && !meets(around.goal, box)) boxes.push_back(box);
    }
    return boxes;
}

Problem cluttered(Rng& rng, std::size_t n, std::size_t count, double size) {
    Problem result = problem(ring(n, {0.2, 0.2}, 1), ring(n, {0.8, 0.8}, 2));
    result.obstacles = clutter(rng, count, size, result);
    return result;
}

Row row_of(const Chain& chain, const Points& positions) {
    Row row(chain.dimension());
    chain.configuration(positions, row);
    return row;
}

Points positions_of(const Chain& chain, std::span<const double> row) {
    const std::size_t n = chain.asv_count();
    std::vector<double> heading(chain.broom_count());
    double mean = 0;
    for (std::size_t k = 0; k < heading.size(); ++k) {
        heading[k] = k == 0 ? row[2] : heading[k - 1] + row[2 + k];
        mean += heading[k] / static_cast<double>(heading.size());
    }
    if (chain.anchor() == Anchor::centroid)
        for (double& h : heading) h += row[2] - mean;
    Points points{{0, 0}};
    for (const double h : heading) {
        const Point& last = points.back();
        points.push_back({last.x + chain.broom_length() * std::cos(h),
                          last.y + chain.broom_length() * std::sin(h)});
    }
    Point anchor{0, 0};
    if (chain.anchor() == Anchor::centroid)
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

double along(const Chain& chain, const Configurations& rows, int pieces,
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

void wander(MotionChecker& checker, SlideSteering& steering, Rng& rng, int legs,
            Configurations& path) {
    ShapeSampler sampler(checker);
    const std::size_t d = checker.chain().dimension();
    for (int leg = 0; leg < legs; ++leg) {
        const Row from(path.end() - static_cast<std::ptrdiff_t>(d), path.end());
        Row to(from);
        if (!sampler.sample(rng, to)) continue;
        unwrap(to, from, {2, d > 2 ? 1U : 0U});
        steering.slide(from, to, path);
    }
}

}  // namespace asv::core::testing
