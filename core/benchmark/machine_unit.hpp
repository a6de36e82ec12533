#pragma once

/// A unit of time that makes figures of different machines comparable.

namespace asv::core {

/// Seconds that 10^6 plain scalar state checks take on this machine now: a chain of 7 ASVs among 7
/// rectangles, valid states alone, so that no check ends early; each one computes the positions and
/// looks at bounds, turns, area and every rectangle, without SIMD and without an index. The median
/// of some rounds, which take about as long together.
double seconds_per_million_checks();

}  // namespace asv::core
