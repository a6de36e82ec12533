#pragma once

#include <cstdint>
#include <limits>

#include <CLI/CLI.hpp>

namespace asv::tools {

/// More threads or jobs than this are refused.
inline constexpr std::uint64_t max_threads = 1024;

/// For CLI::Option::transform: accepts decimal digits alone ("010" is ten) that make a number from
/// low to high; anything else is an error that tells the range, as the help does.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

/// Likewise a finite decimal number ("0.5", "1e-3") from low to high.
CLI::Validator number_between(double low, double high);
CLI::Validator number_from(double low);
CLI::Validator finite_number();

}  // namespace asv::tools
