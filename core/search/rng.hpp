#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

/// A stream of random numbers that is the same on every machine: xoshiro256** (Blackman and Vigna,
/// 2018) seeded by splitmix64. The draws are our own, because those of the standard library differ
/// from one implementation to the next.
class Rng {
  public:
    explicit Rng(std::uint64_t seed) {
        for (auto& word : state_) {
            seed += 0x9e3779b97f4a7c15u;
            std::uint64_t z = seed;
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
            z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
            word = z ^ (z >> 31);
        }
    }

    /// 64 random bits.
    std::uint64_t bits() {
        const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
        const std::uint64_t shifted = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= shifted;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }

    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in {0, ..., count - 1}. Precondition: 0 < count < 2^32.
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(((bits() >> 32) * count) >> 32);
    }

    /// True with the given probability.
    bool chance(double probability) { return uniform() < probability; }

    /// Standard normal (Box and Muller, 1958).
    double normal() {
        const double radius = std::sqrt(-2 * elementary::log(1 - uniform()));
        return radius * elementary::cos(2 * std::numbers::pi * uniform());
    }

    /// Gamma with the given shape and scale 1 (Marsaglia and Tsang, 2000). Precondition: shape > 0.
    double gamma(double shape) {
        if (shape < 1) return gamma(shape + 1) * elementary::pow(1 - uniform(), 1 / shape);
        const double d = shape - 1.0 / 3.0;
        const double c = 1 / std::sqrt(9 * d);
        while (true) {
            const double x = normal();
            const double v = (1 + c * x) * (1 + c * x) * (1 + c * x);
            if (v > 0 &&
                elementary::log(1 - uniform()) < 0.5 * x * x + d - d * v + d * elementary::log(v))
                return d * v;
        }
    }

  private:
    std::uint64_t state_[4];
};

}  // namespace asv::core
