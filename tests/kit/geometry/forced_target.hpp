#pragma once

#include <string>

#include "geometry/simd/instruction_set.hpp"

namespace asv::test {

/// While it lives, the kernels run on this instruction set.
class ForcedTarget {
  public:
    explicit ForcedTarget(const std::string& target) {
        geometry::simd::use_instruction_set(target);
    }
    ~ForcedTarget() { geometry::simd::use_best_instruction_set(); }
    ForcedTarget(const ForcedTarget&) = delete;
    ForcedTarget& operator=(const ForcedTarget&) = delete;
};

}  // namespace asv::test
