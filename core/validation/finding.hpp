#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/validation/report.hpp"

namespace asv::core::validation {

/// What one check says of one state: whether it holds, and the place with the least room.
struct Finding {
    bool ok = true;
    Offender offender{.asv = {},
                      .broom = {},
                      .obstacle = {},
                      .time = {},
                      .room = std::numeric_limits<double>::infinity()};
};

/// Would a finding with such a verdict and so much room be worse than this one? A violation is
/// worse than none, then less room is worse.
inline bool worse(bool ok, double room, const Finding& than) {
    return ok != than.ok ? than.ok : room < than.offender.room;
}

inline bool worse(const Finding& a, const Finding& b) {
    return worse(a.ok, a.offender.room, b);
}

inline void keep_worse(Finding& worst, Finding candidate) {
    if (worse(candidate, worst)) worst = std::move(candidate);
}

/// What one ASV, point or joint leaves or violates.
inline Finding at_asv(bool ok, std::size_t asv, double room) {
    Finding finding;
    finding.ok = ok;
    finding.offender.asv = asv;
    finding.offender.room = room;
    return finding;
}

/// Adds up the findings of one check.
class Tally {
  public:
    Tally(Check check, bool list_offenders, BodyKind body = BodyKind::chain)
        : list_offenders_(list_offenders), body_(body) {
        result_.check = check;
    }

    void add(const Finding& finding, std::size_t state) {
        ++result_.states;
        if (!finding.ok) ++result_.failures;
        const bool listed = !finding.ok && list_offenders_;
        // Most findings are neither, and are not worth a copy.
        if (!listed && !worse(finding, worst_)) return;
        Finding placed = finding;
        placed.offender.state = state;
        placed.offender.body = body_;
        if (listed) result_.offenders.push_back(placed.offender);
        keep_worse(worst_, std::move(placed));
    }

    const Finding& worst() const { return worst_; }

    CheckResult result() && {
        if (!worst_.ok || std::isfinite(worst_.offender.room)) result_.worst = worst_.offender;
        return std::move(result_);
    }

  private:
    bool list_offenders_;
    BodyKind body_;
    CheckResult result_;
    Finding worst_;
};

}  // namespace asv::core::validation
