#include "core/trajectory/path_pace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asv::core::trajectory {

namespace {

enum class Faster { before, after };

/// The state between two steps. Where the faster one's pace is s times that of the slower one, the
/// velocities of the vehicles change by the slower pace times at most
///
///     change(s) = max over the vehicles of |e_fast s - e_slow|,
///
/// which is convex in s.
class Bend {
  public:
    explicit Bend(const ScaledSteps& steps) : steps_(steps), turns_(steps.vehicles) {}

    /// To the state behind that step. O(vehicles).
    void go_to(std::size_t step, Faster faster) {
        const auto before = steps_.direction(step), after = steps_.direction(step + 1);
        const bool is_after = faster == Faster::after;
        const auto fast = is_after ? after : before, slow = is_after ? before : after;
        slow_length_ = steps_.lengths[is_after ? step : step + 1];
        fast_length_ = steps_.lengths[is_after ? step + 1 : step];
        for (std::size_t i = 0; i < turns_.size(); ++i) {
            const double x = fast[2 * i], y = fast[2 * i + 1];
            const double dx = x - slow[2 * i], dy = y - slow[2 * i + 1];
            turns_[i] = {dx * dx + dy * dy, 2 * (x * dx + y * dy), x * x + y * y};
        }
        even_change_ = change(0);
        greatest_move_ = 0;
        for (const Turn& turn : turns_) greatest_move_ = std::max(greatest_move_, turn.c);
    }

    /// The greatest pace at which both steps may be passed.
    double even_pace() const {
        return std::sqrt((slow_length_ + fast_length_) / (2 * even_change_));
    }

    /// The greatest pace of the faster step, at most `most`, beside the pace of the slower one, so
    /// that every pace between the two is allowed as well: to that end the change counts as at
    /// least that at equal paces. Precondition: slow <= even_pace(), slow < most.
    double greatest(double slow, double most) const {
        double low = 0, high = most / slow - 1;
        if (excess(slow, high).value <= 0) return most;
        constexpr int most_rounds = 60;
        double trial = std::min(guess(slow), high);
        for (int round = 0; round < most_rounds; ++round) {
            const Excess found = excess(slow, trial);
            (found.value <= 0 ? low : high) = trial;
            if (found.value <= 0 && found.value >= -accuracy) break;
            // Newton's step, to within what is accurate enough, or half of what is left.
            trial -= (found.value + accuracy / 2) / found.slope;
            if (!(trial > low && trial < high)) trial = low + (high - low) / 2;
        }
        return slow * (1 + low);
    }

  private:
    /// Of the limits, by which a pace may stay below what they allow.
    static constexpr double accuracy = 1e-9;
    /// Of the mean speeds in the second and the first of two steps of one length, evenly
    /// accelerated from rest; less one.
    static constexpr double greatest_gain_from_rest = std::numbers::sqrt2;

    /// The squared change of a vehicle's velocity is a + b t + c t^2 at s = 1 + t.
    struct Turn {
        double a, b, c;
        double at(double t) const { return a + t * (b + t * c); }
    };

    /// By which share the velocities change too much, and how fast that grows with t.
    struct Excess {
        double value, slope;
    };

    const Turn& greatest_turn(double t) const {
        const Turn* greatest = &turns_.front();
        double most = greatest->at(t);
        for (const Turn& turn : turns_) {
            const double value = turn.at(t);
            if (value <= most) continue;
            most = value;
            greatest = &turn;
        }
        return *greatest;
    }

    double change(double t) const { return std::sqrt(greatest_turn(t).at(t)); }

    /// At s = 1 + t; the value grows with t.
    Excess excess(double slow, double t) const {
        const double s = 1 + t;
        const double time = s * slow_length_ + fast_length_, law_time = slow_length_ + fast_length_;
        double per_time = 2 * s / time, per_time_slope = 2 * fast_length_ / (time * time);
        if (t > greatest_gain_from_rest && (1 + s) / law_time > per_time) {
            per_time = (1 + s) / law_time;
            per_time_slope = 1 / law_time;
        }
        const Turn& turn = greatest_turn(t);
        // Rounding may bring it below 0.
        double change = std::sqrt(std::max(0.0, turn.at(t)));
        double change_slope = (turn.b / 2 + t * turn.c) / change;
        if (change <= even_change_) {
            change = even_change_;
            change_slope = 0;
        }
        const double square = slow * slow;
        return {square * per_time * change - 1,
                square * (per_time * change_slope + per_time_slope * change)};
    }

    /// Where the excess would be 0 if nothing turned.
    double guess(double slow) const {
        const double c = 2 * slow * slow * std::sqrt(greatest_move_),
                     length = slow_length_ + fast_length_;
        // c (1 + t) t = (1 + t) slow_length_ + fast_length_, and (2 + t) t = 2 length / c.
        const double half = (slow_length_ - c) / 2;
        const double by_times = (half + std::sqrt(half * half + c * length)) / c;
        if (by_times <= greatest_gain_from_rest) return by_times;
        const double by_law = std::sqrt(1 + 2 * length / c) - 1;
        return std::max(greatest_gain_from_rest, std::min(by_times, by_law));
    }

    const ScaledSteps& steps_;
    std::vector<Turn> turns_;
    double slow_length_ = 0, fast_length_ = 0;
    double even_change_ = 0;
    double greatest_move_ = 0;  ///< of a vehicle in the faster step, by its length; squared
};

/// From rest, or to it: the velocity changes within half the time of the step.
double pace_beside_rest(const ScaledSteps& steps, std::size_t step) {
    const auto direction = steps.direction(step);
    double most = 0;
    for (std::size_t i = 0; i < direction.size(); i += 2)
        most = std::max(most, direction[i] * direction[i] + direction[i + 1] * direction[i + 1]);
    return std::sqrt(steps.lengths[step] / (2 * std::sqrt(most)));
}

}  // namespace

std::vector<double> paces(const ScaledSteps& steps) {
    std::vector<double> pace = steps.fastest;
    if (pace.empty()) return pace;
    pace.front() = std::min(pace.front(), pace_beside_rest(steps, 0));
    pace.back() = std::min(pace.back(), pace_beside_rest(steps, steps.size() - 1));
    Bend bend(steps);
    for (std::size_t k = 0; k + 1 < pace.size(); ++k) {
        bend.go_to(k, Faster::after);
        const double even = bend.even_pace();
        pace[k] = std::min(pace[k], even);
        pace[k + 1] = std::min(pace[k + 1], even);
    }
    for (std::size_t k = pace.size() - 1; k-- > 0;) {
        if (pace[k] <= pace[k + 1]) continue;
        bend.go_to(k, Faster::before);
        pace[k] = bend.greatest(pace[k + 1], pace[k]);
    }
    for (std::size_t k = 0; k + 1 < pace.size(); ++k) {
        if (pace[k + 1] <= pace[k]) continue;
        bend.go_to(k, Faster::after);
        pace[k + 1] = bend.greatest(pace[k], pace[k + 1]);
    }
    return pace;
}

}  // namespace asv::core::trajectory
