#pragma once

#include <cstddef>

#include "core/certificate_check/exact.hpp"

namespace asv::core::certificate_check {

/// Rows of heights with which the area that a certificate states is compared.
inline constexpr std::size_t rows_of_statements = 256;

/// Of more ASVs than this, rows of heights take too long.
inline constexpr std::size_t most_asvs_in_rows = 100;

/// No chain of so many ASVs, two or more, whose brooms are at most so long, encloses more area
/// together with its closing side while it lies in a strip of that height (0 if it is negative).
/// The more rows, an even number, the nearer to what it can enclose; the work is that of half the
/// cube of the rows, for each broom. Of more ASVs than most_asvs_in_rows it is height times length.
///
/// Let y be the height of a place on the chain, m the mean of those of its two ends, and d = y - m.
/// The area is the integral of d dx around the polygon, since that of m dx is 0. On the closing
/// side d runs from c to -c and adds nothing. A broom from d to d' adds at most |d + d'| / 2 times
/// the root of broom^2 - (d - d')^2. Where need be, look at the chain upside down (m is in the
/// upper half) and from its other end (c >= 0). Divide the strip into rows; for each row that m may
/// be in, the heights d into rows as high; and let the chain go from any row of d >= 0 to any of
/// d <= 0 in the strip, each broom adding what it can add between two rows at most. The roots are
/// rounded up to whole parts; all else are sums and products of whole numbers, below 2^53 so that
/// double is exact.
Number strip_area_at_most(std::size_t asv_count, const Number& broom, const Number& height,
                          std::size_t rows);

}  // namespace asv::core::certificate_check
