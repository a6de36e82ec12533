#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/body.hpp"

/// What the checker finds, and how it is put in words.

namespace asv::core {

/// The eight of a chain of ASVs in the order in which they are reported, then those of an arm
/// alone. An arm is checked for ends, steps, cost, link lengths, base, joint limits, bounds,
/// collisions; a point for ends, steps, cost, bounds, collisions. The last four are those of a
/// trajectory, of any body.
enum class Check {
    ends,
    steps,
    cost,
    broom_lengths,
    convexity,
    area,
    bounds,
    collisions,
    link_lengths,
    base,
    joint_limits,
    times,
    same_path,
    speed,
    acceleration
};
inline constexpr std::size_t check_count = 8;  ///< of a chain of ASVs

/// "ends", "steps", "cost", "broom lengths", ..., "link lengths", "base", "joint limits",
/// "times", "same path", "speed", "acceleration".
std::string_view name(Check check);

/// One violation or, where there is none, the state that comes nearest to one.
struct Offender {
    std::size_t state = 0;                ///< row of the path, 0 is the first; of a step, its end
    std::optional<std::size_t> asv;       ///< 0-based, where one ASV, point or joint is to blame
    std::optional<std::size_t> broom;     ///< 0-based, broom or link i joins points i and i + 1
    std::optional<std::size_t> obstacle;  ///< 0-based index into Problem::obstacles
    std::optional<double> time;           ///< in [0, 1] between the state before and this one
    double room = 0;  ///< what is left to the limit; negative: violated by that much
    BodyKind body = BodyKind::chain;  ///< whose parts are meant
    double length = 0;                ///< of a broom or link whose length is checked, as it is
    double wanted_length = 0;         ///< as it has to be; 0 in all other checks
};

/// The outcome of one check over all states.
struct CheckResult {
    Check check = Check::ends;
    std::size_t states = 0;           ///< how many states (or steps) were looked at
    std::size_t failures = 0;         ///< how many of them violate the requirement
    std::optional<Offender> worst;    ///< the least room; none when there is nothing to violate
    std::vector<Offender> offenders;  ///< the worst of each failed state, where they are asked for
    bool ok() const { return failures == 0; }
};

struct ValidationReport {
    std::vector<CheckResult> checks;
    std::vector<CheckResult> motion;  ///< the checks along the steps, where they are asked for
    double cost = 0;                  ///< as computed here, see Body
    bool valid() const;
};

/// One clause for a violation: "broom 3 meets obstacle 5 by 0.0012", with 1-based numbers.
/// Precondition: the offender violates the check.
std::string describe(Check check, const Offender& offender);

/// The same for the worst offender of a failed check; "room 0.0012 at broom 3, obstacle 5" for the
/// tightest state of one that holds; "nothing to check" without a state to speak of.
std::string describe(const CheckResult& result);

}  // namespace asv::core
