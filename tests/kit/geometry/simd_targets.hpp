#pragma once

#include <cstdint>
#include <vector>

#include <hwy/targets.h>

namespace asv::test {

/// Every instruction set that the library was compiled for and this processor has, the portable
/// emulation among them.
inline std::vector<std::int64_t> simd_targets() {
    return hwy::SupportedAndGeneratedTargets();
}

/// While it lives, the kernels run on this instruction set.
class ForcedTarget {
  public:
    explicit ForcedTarget(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    ~ForcedTarget() {
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().DeInit();
    }
    ForcedTarget(const ForcedTarget&) = delete;
    ForcedTarget& operator=(const ForcedTarget&) = delete;
};

}  // namespace asv::test
