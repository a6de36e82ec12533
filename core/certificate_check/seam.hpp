#pragma once

#include "core/certificate_check/claims.hpp"
#include "core/certificate_check/facing.hpp"

namespace asv::core::certificate_check {

/// Checks what a certificate says of a seam, and that ASV asv, which has to be in the middle of the
/// chain, never gets half way through it; returns the line that it then never meets.
std::optional<Rectangle> check_seam(const ClosedSeam& seam, const std::string& name,
                                    std::size_t asv, const Problem& problem, const Limits& limits,
                                    Claims& claims);

/// Does no valid chain have the ASV in its middle within half a step of half way through a seam?
/// width: of the seam between walls shrunk by e. depth: of that between walls shrunk by more, by
/// half a step. b is the length of a broom, l that of the chain.
///
/// A broom that has b / 20 of its length in the seam is steep: its angle phi to the seam has a sine
/// of at most z = 20 width / b. On each side of the ASV there is one such broom, and one more for
/// each whole broom that the seam is longer; q in all.
/// - If two of them fold back, the polygon turns by pi - 2 phi or more between them. All turns
///   other than those below e have one sign and sum up to 2 pi. So the headings of all sides lie
///   within pi + 2 phi + 2 n e. The sides sum up to zero, so that those across the middle of that
///   range go at most 2 l sin(phi + n e) one way and as much back, while along it the polygon goes
///   2 l at most: its area is at most 2 l^2 (z + n e).
/// - Else they lead along a chord of at most s = q (b + e). Take r from an end of it. The integral
/// of
///   |r x dr| / 2 over the two arms beside it, of a and a', is at most a^2 / 4 + (a'^2 + 2 s a') /
///   4, over the closing side at most a (a' + s) / 2: together (l^2 - s^2) / 4. Between the brooms
///   and the chord is at most s^2 tan(phi) / 4.
bool is_impassable(const Number& width, const Number& depth, const Problem& problem,
                   const Limits& limits);

}  // namespace asv::core::certificate_check
