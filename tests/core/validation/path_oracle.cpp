#include "tests/core/validation/path_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/kit/geometry/exact_oracle.hpp"

namespace asv::test {

namespace {

using core::Requirements;
using geometry::Box;
using geometry::Point;
using State = std::span<const Point>;

/// Has all digits of sums and products of coordinates that are not smaller than 10^-30.
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                            boost::multiprecision::et_off>;

constexpr double u = 0x1p-53;

/// One state that fails makes a path fail; else one in doubt leaves it in doubt.
void keep_worse(Verdict& all, Verdict one) {
    if (one == Verdict::fails || all == Verdict::holds) all = one == Verdict::holds ? all : one;
}

/// The checks in numbers of one type. For nearly all paths, long double is enough: it rounds by the
/// bounds of double with a u that is 2048 times smaller, so a verdict that twice the doubt does not
/// reach stands.
template <class Real>
class Checks {
  public:
    explicit Checks(const Requirements& required) : required_(required), e_(required.tolerance) {}

    Verdict broom_lengths(State state) const {
        Verdict all = Verdict::holds;
        for (std::size_t i = 1; i < state.size(); ++i) {
            const Real found = length(state[i - 1], state[i]), wanted = required_.broom_length;
            keep_worse(all, verdict(e_ - abs(found - wanted), rounding_of_lengths(found, wanted)));
        }
        return all;
    }

    /// Headings, 0 where a side is a point, and turns between them. A heading errs by u for the
    /// rounded sides and by 0.55 ulp, 2.2 u, for the arc tangent; a turn by two of them, 4 u for
    /// the difference, 2.2 u for a full turn in double and 2 u for what is added to that: 15 u. A
    /// sum up to 3 pi adds 8 u for each turn and once 4 u for 3 pi itself.
    Verdict convexity(State state) const {
        constexpr double doubt = 16 * u, doubt_of_sum = 32 * u;
        const std::size_t n = state.size();
        Real left = -pi_, right = pi_, sharpest = 0, total = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point &a = state[i], &b = state[(i + 1) % n], &c = state[(i + 2) % n];
            const Real angle = turn(heading(a, b), heading(b, c));
            left = std::max(left, angle);
            right = std::min(right, angle);
            sharpest = std::max(sharpest, Real(abs(angle)));
            total += abs(angle);
        }
        // A turn of pi may be one to either side.
        if (pi_ - sharpest <= 2 * doubt) return Verdict::in_doubt;
        Verdict all = verdict(e_ - std::min(left, Real(-right)), doubt);
        keep_worse(all, verdict(3 * pi_ - total, doubt_of_sum * static_cast<double>(n)));
        return all;
    }

    /// A product of sides errs by 3 u, a difference of two by another u, and the sum of n - 2 by
    /// n u; the least area by 5 u and its difference from e by u.
    Verdict area(State state) const {
        const auto n = static_cast<double>(state.size());
        const Point& origin = state[0];
        Real twice = 0, size = 0;
        for (std::size_t i = 1; i + 1 < state.size(); ++i) {
            const Point &a = state[i], &b = state[i + 1];
            const Real left = (Real(a.x) - origin.x) * (Real(b.y) - origin.y);
            const Real right = (Real(a.y) - origin.y) * (Real(b.x) - origin.x);
            twice += left - right;
            size += abs(left) + abs(right);
        }
        const Real radius = Real(required_.area_radius_per_broom) * (n - 1);
        const Real least = pi_ * radius * radius;
        return verdict(abs(twice) / 2 - (least - e_), u * ((n + 4) * size / 2 + 7 * (least + e_)));
    }

    /// Only the limits are rounded, and not with a tolerance of 0. The upper ones are out of
    /// bounds.
    Verdict bounds(State state) const {
        const Box& box = required_.bounds;
        Verdict all = Verdict::holds;
        const auto note = [&](const Real& room, double limit, Verdict at_limit) {
            keep_worse(all, verdict(room, e_ == 0 ? e_ : u * (std::abs(limit) + e_), at_limit));
        };
        for (const Point& p : state) {
            note(p.x - (box.low.x - e_), box.low.x, Verdict::holds);
            note(p.y - (box.low.y - e_), box.low.y, Verdict::holds);
            note(box.high.x + e_ - p.x, box.high.x, Verdict::fails);
            note(box.high.y + e_ - p.y, box.high.y, Verdict::fails);
        }
        return all;
    }

    Verdict steps(State from, State to) const {
        return within(from, to, Real(required_.max_step) + e_);
    }

    Verdict ends(State state, State wanted) const { return within(state, wanted, e_); }

    /// The validator does not blame the rounding of its sum, and is right by as much as it rounds.
    Verdict cost(const core::Path& path, double written) const {
        Real sum = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            for (std::size_t k = 0; k < path.asv_count(); ++k)
                sum += length(path.state(i - 1)[k], path.state(i)[k]);
        const auto additions = static_cast<double>(path.size() + path.asv_count());
        constexpr double of_terms = 10;  // a distance, and the difference of both sums
        const Real rounding = (additions + of_terms) * u * (sum + std::abs(written));
        return verdict(e_ - abs(written - sum), 2 * rounding);
    }

  private:
    static Real square_root(const Real& value) {
        using std::sqrt;
        return sqrt(value);
    }

    static Real abs(const Real& value) { return value < 0 ? Real(-value) : value; }

    /// The room that is left, and whether it can be told from none.
    static Verdict verdict(const Real& room, const Real& doubt, Verdict at_limit = Verdict::holds) {
        if (room == 0 && doubt == 0) return at_limit;
        constexpr int of_real = std::is_same_v<Real, Exact> ? 1 : 2;
        if (abs(room) <= of_real * doubt) return Verdict::in_doubt;
        return room > 0 ? Verdict::holds : Verdict::fails;
    }

    static Real length(const Point& a, const Point& b) {
        const Real dx = Real(b.x) - a.x, dy = Real(b.y) - a.y;
        return square_root(dx * dx + dy * dy);
    }

    /// Where a length is compared with a limit. A side of it errs by u, its square by 3 u, their
    /// sum by 4 u, and the root by 3 u, half of that and its own; the limit, if it is a sum, and
    /// the difference by u each. Squares below the smallest numbers vanish. Equal numbers have no
    /// distance, however it is rounded.
    static Real rounding_of_lengths(const Real& found, const Real& limit) {
        constexpr double vanishing = 0x1p-500;
        return 5 * u * (found + limit) + (found == 0 ? 0 : vanishing);
    }

    static Verdict within(State from, State to, const Real& limit) {
        Verdict all = Verdict::holds;
        for (std::size_t i = 0; i < from.size(); ++i) {
            const Real found = length(from[i], to[i]);
            keep_worse(all, verdict(limit - found, rounding_of_lengths(found, limit)));
        }
        return all;
    }

    static Real heading(const Point& a, const Point& b) {
        using std::atan2;
        if (a == b) return 0;
        return atan2(Real(Real(b.y) - a.y), Real(Real(b.x) - a.x));
    }

    /// From one heading to the next, in (-pi, pi].
    Real turn(const Real& from, const Real& to) const {
        const Real angle = to - from;
        if (angle > pi_) return angle - 2 * pi_;
        return angle <= -pi_ ? Real(angle + 2 * pi_) : angle;
    }

    const Requirements& required_;
    const Real e_;
    const Real pi_ = boost::math::constants::pi<Real>();
};

/// By the check's long double, and by its hundred digits where that leaves a doubt.
template <class Check>
Verdict judge(const Requirements& required, Check&& check) {
    const Verdict quick = check(Checks<long double>(required));
    return quick == Verdict::in_doubt ? check(Checks<Exact>(required)) : quick;
}

/// Each side moved out by one bit, or in.
Box moved_by_a_bit(const Box& box, bool out) {
    const double less =
        out ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    return {{std::nextafter(box.low.x, less), std::nextafter(box.low.y, less)},
            {std::nextafter(box.high.x, -less), std::nextafter(box.high.y, -less)}};
}

bool is_met(const geometry::Segment& broom, const Box& box) {
    return !geometry::is_empty(box) && exact_meets(broom, box);
}

/// A rounded side of a shrunk box lies beside its exact place, by less than one bit.
Verdict collision(const geometry::Segment& broom, const Box& box, double e) {
    const Box shrunk = geometry::grown(box, -e);
    const bool exact = e == 0;
    if (!is_met(broom, exact ? shrunk : moved_by_a_bit(shrunk, true))) return Verdict::holds;
    const bool surely = is_met(broom, exact ? shrunk : moved_by_a_bit(shrunk, false));
    return surely ? Verdict::fails : Verdict::in_doubt;
}

Verdict collisions(State state, const std::vector<Box>& boxes, double e) {
    Verdict all = Verdict::holds;
    for (std::size_t i = 1; i < state.size(); ++i)
        for (const Box& box : boxes) keep_worse(all, collision({state[i - 1], state[i]}, box, e));
    return all;
}

}  // namespace

std::array<Verdict, core::check_count> oracle_verdicts(const core::Problem& problem,
                                                       const core::Solution& solution, double e) {
    Requirements required = problem.requirements;
    required.tolerance = e;
    const core::Path& path = solution.path;
    std::array<Verdict, core::check_count> verdicts{};
    const auto note = [&](core::Check check, Verdict one) {
        keep_worse(verdicts[static_cast<std::size_t>(check)], one);
    };
    for (std::size_t i = 0; i < path.size(); ++i) {
        const State state = path.state(i);
        using core::Check;
        const auto of_state = [&](auto member) {
            return judge(required, [&](const auto& checks) { return member(checks, state); });
        };
        note(Check::broom_lengths,
             of_state([](const auto& checks, State s) { return checks.broom_lengths(s); }));
        note(Check::convexity,
             of_state([](const auto& checks, State s) { return checks.convexity(s); }));
        note(Check::area, of_state([](const auto& checks, State s) { return checks.area(s); }));
        note(Check::bounds, of_state([](const auto& checks, State s) { return checks.bounds(s); }));
        note(Check::collisions, collisions(state, problem.obstacles, e));
        if (i > 0)
            note(Check::steps, judge(required, [&](const auto& checks) {
                     return checks.steps(path.state(i - 1), state);
                 }));
    }
    for (const auto& [state, wanted] :
         {std::pair(path.state(0), State(problem.start)),
          std::pair(path.state(path.size() - 1), State(problem.goal))}) {
        const State at = state, end = wanted;
        note(core::Check::ends,
             judge(required, [&](const auto& checks) { return checks.ends(at, end); }));
    }
    note(core::Check::cost,
         judge(required, [&](const auto& checks) { return checks.cost(path, solution.cost); }));
    return verdicts;
}

}  // namespace asv::test
