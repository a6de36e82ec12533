#include "io/player/held_states.hpp"

#include <algorithm>
#include <limits>

namespace asv::io {

namespace {

/// How many states are held of one stretch, at most.
constexpr std::size_t states_per_stretch = 5;
/// More than the requirements there are, and the last state.
constexpr std::size_t room_for_worst = 20;

std::vector<std::size_t> worst_states(const Exhibit& exhibit) {
    std::vector<std::size_t> states;
    for (const core::CheckResult& check : exhibit.report.checks) {
        if (!check.ok() && check.worst) states.push_back(check.worst->state);
    }
    std::sort(states.begin(), states.end());
    return states;
}

double clearance(const StateMeasures& measures) {
    return measures.clearance ? measures.clearance->distance
                              : std::numeric_limits<double>::infinity();
}

/// Adds those of the states from first to before end that are told by a stretch.
void add_stretch(std::vector<std::size_t>& held, const Exhibit& exhibit, std::size_t first,
                 std::size_t end) {
    const auto begin = exhibit.measures.begin();
    const auto at = [&](std::size_t state) { return begin + static_cast<std::ptrdiff_t>(state); };
    const auto add_least = [&](const auto& value) {
        const auto least = std::min_element(
            at(first), at(end),
            [&](const StateMeasures& a, const StateMeasures& b) { return value(a) < value(b); });
        held.push_back(static_cast<std::size_t>(least - begin));
    };
    held.push_back(first);
    add_least(clearance);
    add_least([](const StateMeasures& m) { return m.area; });
    add_least([](const StateMeasures& m) { return -m.tightest_turn.value_or(0); });
    const auto violation = std::lower_bound(
        exhibit.violations.begin(), exhibit.violations.end(), first,
        [](const Violation& v, std::size_t state) { return v.offender.state < state; });
    if (violation != exhibit.violations.end() && violation->offender.state < end)
        held.push_back(violation->offender.state);
}

}  // namespace

std::vector<std::size_t> held_states(const Exhibit& exhibit, std::size_t limit) {
    const std::size_t count = exhibit.measures.size();
    std::vector<std::size_t> held;
    if (count <= limit) {
        held.resize(count);
        for (std::size_t i = 0; i < count; ++i) held[i] = i;
        return held;
    }
    held = worst_states(exhibit);
    held.push_back(count - 1);
    const std::size_t stretches = (limit - room_for_worst) / states_per_stretch;
    for (std::size_t k = 0; k < stretches; ++k)
        add_stretch(held, exhibit, count * k / stretches, count * (k + 1) / stretches);
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    return held;
}

std::vector<Violation> held_violations(const Exhibit& exhibit, std::span<const std::size_t> states,
                                       std::size_t limit) {
    std::vector<Violation> held;
    for (const Violation& violation : exhibit.violations) {
        if (std::binary_search(states.begin(), states.end(), violation.offender.state))
            held.push_back(violation);
    }
    if (held.size() <= limit) return held;
    const std::vector<std::size_t> worst = worst_states(exhibit);
    const auto rest = std::stable_partition(held.begin(), held.end(), [&](const Violation& v) {
        return std::binary_search(worst.begin(), worst.end(), v.offender.state);
    });
    const auto first = static_cast<std::size_t>(rest - held.begin());
    const std::size_t kept = limit - std::min(limit, first);
    const std::size_t others = held.size() - first;
    for (std::size_t k = 0; k < kept; ++k) held[first + k] = held[first + others * k / kept];
    held.resize(first + kept);
    return held;
}

}  // namespace asv::io
