#include "tests/kit/chains/configuration_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::test {

double Oracle::shape_room(const Points& points, std::span<const double> row) const {
    const core::ChainConstraints& limits = world_.constraints;
    const double length = world_.chain.broom_length();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 3 < row.size(); ++i)
        least = std::min({least, length * (row[3 + i] - limits.min_turn[i]),
                          length * (limits.max_turn - row[3 + i])});
    const std::size_t n = points.size();
    if (n < 3) return least;
    const auto heading = [&](std::size_t a, std::size_t b) {
        return std::atan2(points[b].y - points[a].y, points[b].x - points[a].x);
    };
    const double closing = std::hypot(points[0].x - points[n - 1].x, points[0].y - points[n - 1].y);
    const double into = std::sin(heading(n - 1, 0) - heading(n - 2, n - 1));
    const double out_of = std::sin(heading(0, 1) - heading(n - 1, 0));
    return std::min({least, closing * into - limits.min_last_closing_turn,
                     closing * out_of - limits.min_first_closing_turn,
                     closing - limits.min_closing_side,
                     (geometry::signed_area(points) - limits.min_area) / length});
}

double Oracle::outside_room(const Points& points) const {
    const core::ChainConstraints& limits = world_.constraints;
    double least = std::numeric_limits<double>::infinity();
    for (const Point& p : points)
        least = std::min({least, p.x - limits.bounds.low.x, limits.bounds.high.x - p.x,
                          p.y - limits.bounds.low.y, limits.bounds.high.y - p.y});
    for (std::size_t k = 0; k < std::max<std::size_t>(points.size() - 1, 1); ++k) {
        const geometry::Segment broom{points[k], points[std::min(k + 1, points.size() - 1)]};
        for (const geometry::Box& box : limits.obstacles) {
            if (!geometry::overlap(geometry::bounds(broom), geometry::grown(box, 0.05))) continue;
            const double gap = geometry::distance(broom, box);
            least = std::min(least, gap > 0 ? gap : -1e-3);
        }
    }
    return least;
}

double Oracle::room(std::span<const double> row) const {
    const Points points = positions_of(world_.chain, row);
    return std::min(shape_room(points, row), outside_room(points));
}

Oracle::Lowest Oracle::lowest(std::span<const double> from, std::span<const double> to,
                              std::size_t samples) const {
    const auto at = [&](double t) { return room(between(from, to, t)); };
    std::vector<Lowest> found;
    for (std::size_t i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(samples);
        found.push_back({at(t), t});
    }
    const auto lower = [](const Lowest& a, const Lowest& b) { return a.room < b.room; };
    const std::size_t refined = std::min<std::size_t>(3, found.size());
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(refined),
                      found.end(), lower);
    Lowest best = found.front();
    for (std::size_t i = 0; i < refined; ++i) {
        double width = 1 / static_cast<double>(samples);
        Lowest middle = found[i];
        for (int step = 0; step < 50; ++step, width *= 0.7)
            for (const double t : {middle.t - width, middle.t + width})
                if (t >= 0 && t <= 1) middle = std::min(middle, {at(t), t}, lower);
        best = std::min(best, middle, lower);
    }
    return best;
}

bool Oracle::judged_valid(std::span<const double> row) const {
    return core::validate_state(world_.problem, positions_of(world_.chain, row)).valid();
}

double Oracle::moved(std::span<const double> a, std::span<const double> b) const {
    return farthest_move(positions_of(world_.chain, a), positions_of(world_.chain, b));
}

void Oracle::expect_valid_path(const std::vector<double>& rows, std::size_t samples) const {
    const std::size_t d = world_.chain.dimension();
    for (std::size_t i = 1; i < rows.size() / d; ++i) {
        const auto from = nth(rows, d, i - 1), to = nth(rows, d, i);
        const Lowest worst = lowest(from, to, samples);
        ASSERT_GE(worst.room, -1e-12) << "motion " << i << " at " << worst.t;
        ASSERT_TRUE(judged_valid(between(from, to, worst.t))) << "motion " << i;
    }
}

}  // namespace asv::test
