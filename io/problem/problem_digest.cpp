#include "io/problem/problem_digest.hpp"

#include <array>
#include <cstdint>
#include <cstdio>

#include "io/problem/scenario_text.hpp"

namespace asv::io {

std::string problem_digest(const core::Problem& problem) {
    // Fowler, Noll and Vo: the offset and the prime of 64 bits.
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char letter : format_scenario(problem)) {
        hash ^= static_cast<unsigned char>(letter);
        hash *= 0x100000001b3;
    }
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace asv::io
