#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/setting.hpp"
#include "core/search/trees/interpolate.hpp"

/// Trees that are extended by single steps, as textbooks and older programs have it.

namespace asv::core {

/// How a tree is extended toward a configuration.
enum class ExtendBy {
    whole,  ///< as its space steers: in few motions, proven whole
    steps   ///< step by step, each checked on its own
};

/// Which steps of an extension become nodes.
enum class StepNodes { each, last };

/// What each field is, settings_of() says below.
struct SingleStepOptions {
    ExtendBy extend = ExtendBy::whole;
    double step = 0;
    StepNodes nodes = StepNodes::each;
};

inline std::vector<Setting> settings_of(SingleStepOptions& options) {
    return {
        {.name = "extend",
         .meaning = "extend a tree by whole proven motions, or by single steps straight ahead",
         .value = one_of(options.extend, {"whole", "steps"}),
         .why = "where a whole motion is blocked, enlargement and ladder go on; steps are for "
                "comparison with the report on extensions",
         .source = "Kuffner and LaValle 2000"},
        {.name = "extend-step",
         .meaning = "length of such a step at most; 0: a thousandth of the longest side",
         .value = number(options.step, 0, 1e3, in_metric),
         .why = "0.001 for a small chain in the unit square, the primitive step of the report",
         .source = "report on seven extensions"},
        {.name = "extend-nodes",
         .meaning = "steps that become nodes: each one, or the last of an extension",
         .value = one_of(options.nodes, {"each", "last"}),
         .why = "each, as published; last, as in the Motion Strategy Library, suits the reported "
                "figures, which have 50 checks for each node",
         .source = "Kuffner and LaValle 2000"},
    };
}

/// How far the body moves on a straight motion, in the units of the space's extent(): the distance,
/// unless the space says better.
template <class Space>
double length_of_motion(Space& space, std::span<const double> from, std::span<const double> to) {
    if constexpr (requires { space.motion_length(from, to); })
        return space.motion_length(from, to);
    else
        return space.distance(from, to);
}

/// A space that steers by single steps straight toward the target, until one of them is not proven
/// valid, and is the given space in all other operations of a SampledSpace.
template <SampledSpace Space>
class SingleSteps {
    using Row = std::span<const double>;

  public:
    /// Limits are looked at between extensions, so that none may go on for long.
    static constexpr double most_steps = 10'000;

    /// Precondition: a step longer than 0; the space outlives this one.
    SingleSteps(Space& space, const SingleStepOptions& options)
        : space_(space), options_(options), at_(space.dimension()), next_(space.dimension()) {}

    /// All steps of one extension are equally long. One of more than most_steps ends after those.
    Steered steer(Row from, Row target, Configurations& visited) {
        const double length = length_of_motion(space_, from, target);
        const double count = std::max(1.0, std::ceil(length / options_.step));
        const std::size_t before = visited.size();
        std::copy(from.begin(), from.end(), at_.begin());
        Steered outcome = Steered::trapped;
        tried_ = 0;
        while (static_cast<double>(tried_) < std::min(count, most_steps)) {
            const auto step = static_cast<double>(++tried_);
            std::copy(target.begin(), target.end(), next_.begin());
            if (step < count) interpolate(from, target, step / count, next_);
            if (!space_.motion_valid(at_, next_)) return outcome;
            if (options_.nodes == StepNodes::last) visited.resize(before);
            visited.insert(visited.end(), next_.begin(), next_.end());
            outcome = step < count ? Steered::advanced : Steered::reached;
            at_.swap(next_);
        }
        return outcome;
    }

    /// Steps of the last extension, the one that was blocked included.
    std::size_t steps_tried() const { return tried_; }

    bool sample(Rng& rng, std::span<double> out) { return space_.sample(rng, out); }
    std::size_t dimension() const { return space_.dimension(); }
    NearestNeighbours make_index() const { return space_.make_index(); }
    WrappingAngles wrapping() const { return space_.wrapping(); }
    double distance(Row a, Row b) const { return space_.distance(a, b); }
    bool from_unit_cube(Row unit, std::span<double> out) {
        return space_.from_unit_cube(unit, out);
    }
    double extent(std::size_t coordinate) const { return space_.extent(coordinate); }
    void perturb(Rng& rng, Row row, double sigma, std::span<double> out) {
        space_.perturb(rng, row, sigma, out);
    }
    bool collides(Row row) { return space_.collides(row); }
    bool valid(Row row) { return space_.valid(row); }
    bool motion_valid(Row from, Row to) { return space_.motion_valid(from, to); }
    double cost(Row from, Row to) { return space_.cost(from, to); }
    double cost_lower_bound(Row from, Row to) { return space_.cost_lower_bound(from, to); }

  private:
    Space& space_;
    SingleStepOptions options_;
    std::vector<double> at_, next_;
    std::size_t tried_ = 0;
};

}  // namespace asv::core
