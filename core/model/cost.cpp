#include "core/model/cost.hpp"

#include <cmath>
#include <cstddef>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Kahan's summation (1965).
class Sum {
  public:
    void add(double summand) {
        const double term = summand - lost_;
        const double next = total_ + term;
        lost_ = (next - total_) - term;
        total_ = next;
    }
    double total() const { return total_; }

  private:
    double total_ = 0, lost_ = 0;
};

/// By how much a link turns from one state to the next, the short way.
double turn_of_link(std::span<const Point> from, std::span<const Point> to, std::size_t link) {
    const double ax = from[link + 1].x - from[link].x, ay = from[link + 1].y - from[link].y;
    const double bx = to[link + 1].x - to[link].x, by = to[link + 1].y - to[link].y;
    return elementary::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

double joint_way(const PlanarArm& arm, std::span<const Point> from, std::span<const Point> to) {
    double sum = 0, before = 0;
    for (std::size_t i = 0; i < arm.links.size(); ++i) {
        const double turn = turn_of_link(from, to, i);
        const double angle = arm.angles == AngleReference::x_axis ? turn : turn - before;
        before = turn;
        sum += angle * angle;
    }
    return std::sqrt(sum);
}

}  // namespace

double cost(const Path& path) {
    Sum sum;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto from = path.state(i - 1), to = path.state(i);
        for (std::size_t j = 0; j < path.asv_count(); ++j)
            sum.add(elementary::hypot(to[j].x - from[j].x, to[j].y - from[j].y));
    }
    return sum.total();
}

double cost(const Problem& problem, const Path& path) {
    if (!problem.arm()) return cost(path);
    Sum sum;
    for (std::size_t i = 1; i < path.size(); ++i)
        sum.add(joint_way(*problem.arm(), path.state(i - 1), path.state(i)));
    return sum.total();
}

double step_cost(const Problem& problem, std::span<const Point> from, std::span<const Point> to) {
    if (const PlanarArm* arm = problem.arm()) return joint_way(*arm, from, to);
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        sum += elementary::hypot(to[i].x - from[i].x, to[i].y - from[i].y);
    return sum;
}

}  // namespace asv::core
