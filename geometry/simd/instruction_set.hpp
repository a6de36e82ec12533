#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asv::geometry::simd {

/// The instruction sets that the kernels are compiled for and this processor has, the best first,
/// by Highway's names: on x86 AVX3 (which is AVX-512), AVX2, SSE4; on Arm NEON; SCALAR or EMU128 is
/// portable C++. Never empty.
std::vector<std::string> instruction_sets();

/// The one that the kernels run on: the best, as long as no other was asked for.
std::string instruction_set();

/// From now on the kernels of this process run on this instruction set. All give the same answers.
/// Throws std::invalid_argument when the name is not one of instruction_sets(); then nothing
/// changes.
void use_instruction_set(std::string_view name);

/// From now on they run on the best one again.
void use_best_instruction_set();

/// Uses the instruction set that the environment variable ASV_SIMD names, where it is there and not
/// empty. Throws like use_instruction_set().
void use_instruction_set_of_environment();

}  // namespace asv::geometry::simd
