#pragma once

namespace asv::core {

struct ValidationOptions {
    /// e of every requirement, in the unit of what is required (workspace units, their squares for
    /// the area), 0 or more. That of the public assignment.
    double tolerance = 1e-5;
    /// Also certify the motion between the primitive steps. Off: the assignment asks of states.
    bool continuous = false;
    /// Fill CheckResult::offenders. Off: the worst one suffices for a verdict.
    bool list_offenders = false;
};

}  // namespace asv::core
