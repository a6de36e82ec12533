#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Statistics of measurements: pure functions of numbers, which know nothing of planners. A value
/// has the unit of what was measured. The same arguments give the same result, on every machine.

namespace asv::core::statistics {

// Quantiles

/// The quantile of values in ascending order, between two of them linearly (type 7 of Hyndman and
/// Fan, 1996): 0 is the least, 0.5 the median, 1 the greatest. Precondition: not empty, 0 <= share
/// <= 1.
double quantile(std::span<const double> ascending, double share);

/// Of some values; all 0 without any.
struct Spread {
    std::size_t count = 0;
    double least = 0, median = 0, greatest = 0;
    double mean = 0;
    double deviation = 0;  ///< of the sample (n - 1); 0 for a single value
};

Spread spread_of(std::vector<double> values);

// Values that may be cut off at a limit (right-censored)

/// A value; where it is censored, the value is not known, but to be greater than this.
struct CensoredValue {
    double value = 0;
    bool censored = false;

    bool operator==(const CensoredValue&) const = default;
};

/// Measurements, some of which ended at a limit without a value.
struct CensoredSample {
    std::vector<double> known;  ///< ascending
    std::size_t censored = 0;   ///< further ones, each of which is known to exceed the limit only
    double limit = 0;

    std::size_t size() const { return known.size() + censored; }
};

/// quantile() of all measurements, the censored ones behind the known ones. A quantile that a
/// censored one has a part in is censored itself: its value is what the quantile were if each of
/// them had ended at the limit, and the true one is greater. Precondition: not empty, 0 <= share
/// <= 1.
CensoredValue quantile(const CensoredSample& sample, double share);

/// That of PAR-2, the penalised average run time that competitions of solvers rank by.
inline constexpr double usual_penalty = 2;

/// The mean of all measurements, a censored one counting `penalty` times the limit. Precondition:
/// not empty.
double penalised_mean(const CensoredSample& sample, double penalty = usual_penalty);

// Confidence intervals

/// That of all intervals here, unless told otherwise.
inline constexpr double usual_confidence = 0.95;

struct Interval {
    double low = 0, high = 0;
};

struct CensoredInterval {
    CensoredValue low, high;
};

/// Of a rate of success, from `successes` in `trials` independent trials (Clopper and Pearson,
/// 1934): it holds the true rate with at least the given probability, however few trials there
/// are. Precondition: successes <= trials, 0 < trials, 0 < confidence < 1.
Interval success_interval(std::size_t successes, std::size_t trials,
                          double confidence = usual_confidence);

struct BootstrapOptions {
    double confidence = usual_confidence;  ///< between 0 and 1
    /// Samples that are drawn, 1 or more: Efron and Tibshirani (1993) ask for 1000 at least.
    std::size_t resamples = 2000;
    std::uint64_t seed = 1;  ///< any; a fixed one, so that the same sample has the same interval
};

/// Of the median, by the percentile bootstrap (Efron and Tibshirani, 1993, chapter 13): samples of
/// the same size are drawn with replacement, and the middle share of their medians is the
/// interval. An end is censored where a censored median may lie at or below it. A single
/// measurement gives an interval without extent. Precondition: not empty, fewer than 2^32.
CensoredInterval median_interval(const CensoredSample& sample,
                                 const BootstrapOptions& options = {});

// Paired comparison

/// The result of a signed rank test.
struct SignedRank {
    std::size_t pairs = 0;                          ///< all of them
    std::size_t differing = 0;                      ///< those whose difference is not 0
    double positive_ranks = 0, negative_ranks = 0;  ///< sums of the ranks
    double p = 1;                                   ///< two-sided, 0 to 1
    bool exact = true;                              ///< or else by the normal distribution
};

/// The signed rank test of Wilcoxon (1945) of paired differences: are they symmetric about 0? Equal
/// magnitudes share the mean of their ranks; differences of 0 are ranked with the others, and their
/// ranks left out of both sums (Pratt, 1959). Up to 200 differences other than 0, p is exact: the
/// share of all ways to give signs to these very ranks, ties included, whose sums are at least as
/// far apart. Beyond, it is that of the normal distribution with the variance of these ranks, with
/// a correction for continuity. Without any difference p is 1. Throws std::invalid_argument for a
/// difference that is not finite.
SignedRank signed_rank_test(std::span<const double> differences);

/// Several p, corrected for their number, in the order given (Holm, 1979): to call those below a
/// level significant makes any false one with at most the probability of that level.
std::vector<double> holm(std::span<const double> p);

/// The chance that a value of the first sample is less than one of the second, equal ones counting
/// half: A12 of Vargha and Delaney (2000) for what is better when less. 0.5 is no difference, 1
/// always less; Cliff's delta is 2 A12 - 1. Precondition: neither is empty.
double chance_of_less(std::span<const double> first, std::span<const double> second);

}  // namespace asv::core::statistics
