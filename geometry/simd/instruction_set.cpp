#include "geometry/simd/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>

#include "geometry/simd/dispatch.hpp"

namespace asv::geometry::simd {

namespace {

/// Those of Highway's targets that the processor has and the operating system lets programs use,
/// among others that the kernels are not compiled for. Highway's own library would tell as well,
/// but measures the clock of the processor for some milliseconds whenever a program that is linked
/// with it starts.
std::int64_t targets_of_processor() {
#if HWY_ARCH_X86
    __builtin_cpu_init();
    std::int64_t targets = HWY_STATIC_TARGET;
    if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("aes") ||
        !__builtin_cpu_supports("pclmul"))
        return targets;
    targets |= HWY_SSE4;
    // Highway's AVX2 is also LZCNT and F16C, for which not every compiler knows a name: all
    // processors with these have them.
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") ||
        !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2"))
        return targets;
    targets |= HWY_AVX2;
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
        !__builtin_cpu_supports("avx512dq") || !__builtin_cpu_supports("avx512bw"))
        return targets;
    return targets | HWY_AVX3;
#else
    // The sets beyond the least that the compiler expects are switched off there.
    return HWY_TARGETS;
#endif
}

std::int64_t usable_targets() {
    static const std::int64_t targets = targets_of_processor() & HWY_TARGETS;
    return targets;
}

/// The best is the lowest bit.
std::int64_t best(std::int64_t targets) {
    return targets & -targets;
}

struct StartingWithAll : hwy::ChosenTarget {
    StartingWithAll() { Update(usable_targets()); }
};

/// What the kernels run on is one thing for a process, as the processor is.
hwy::ChosenTarget& chosen() {
    static StartingWithAll target;
    return target;
}

std::atomic<std::int64_t>& asked_for() {
    static std::atomic<std::int64_t> target = best(usable_targets());
    return target;
}

void use(std::int64_t target) {
    asked_for() = target;
    chosen().Update(target);
}

}  // namespace

const hwy::ChosenTarget& chosen_target() noexcept {
    return chosen();
}

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (std::int64_t left = usable_targets(); left != 0; left &= ~best(left))
        names.emplace_back(hwy::TargetName(best(left)));
    return names;
}

std::string instruction_set() {
    return hwy::TargetName(asked_for());
}

void use_instruction_set(std::string_view name) {
    std::string known;
    for (std::int64_t left = usable_targets(); left != 0; left &= ~best(left)) {
        if (name == hwy::TargetName(best(left))) return use(best(left));
        known += known.empty() ? "" : ", ";
        known += hwy::TargetName(best(left));
    }
    throw std::invalid_argument("no instruction set '" + std::string(name) +
                                "' on this processor: it has " + known);
}

void use_best_instruction_set() {
    use(best(usable_targets()));
}

void use_instruction_set_of_environment() {
    const char* name = std::getenv("ASV_SIMD");
    if (name == nullptr || *name == '\0') return;
    try {
        use_instruction_set(name);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string("ASV_SIMD: ") + error.what());
    }
}

}  // namespace asv::geometry::simd
