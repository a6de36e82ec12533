#pragma once

namespace asv::core {

struct ValidationOptions {
    double tolerance = 1e-5;      ///< e of every requirement
    bool continuous = false;      ///< also certify the motion between the primitive steps
    bool list_offenders = false;  ///< fill CheckResult::offenders
};

}  // namespace asv::core
