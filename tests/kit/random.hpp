#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace asv::test {

/// The tests' own stream of random numbers: the same on every platform, as the distributions of
/// the standard library are not, and no part of what is tested, as core::Rng is.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// 64 random bits.
    std::uint64_t bits() { return engine_(); }

    /// Uniform in [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }

    /// Uniform among 0 .. count - 1. Precondition: count > 0.
    std::size_t below(std::size_t count) { return engine_() % count; }

    /// The same for an int.
    int pick(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

    /// True in one of so many draws.
    bool one_in(std::size_t count) { return below(count) == 0; }

  private:
    std::mt19937_64 engine_;
};

}  // namespace asv::test
