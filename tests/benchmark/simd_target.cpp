#include "tests/benchmark/simd_target.hpp"

#include <cstdint>
#include <vector>

#include <hwy/targets.h>

namespace asv::geometry {

bool force_simd_target(const std::string& name) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name != hwy::TargetName(target)) continue;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        return true;
    }
    return false;
}

std::string simd_target_names() {
    std::string names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (!names.empty()) names += ' ';
        names += hwy::TargetName(target);
    }
    return names;
}

std::string chosen_simd_target() {
    const std::string names = simd_target_names();
    return names.substr(0, names.find(' '));
}

}  // namespace asv::geometry
