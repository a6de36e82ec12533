#pragma once

#include <span>
#include <vector>

#include "core/validation/validate.hpp"
#include "tests/kit/chains/chains.hpp"

namespace asv::test {

/// The checks of a state that fail, in the order of the report, with the tolerance e: the
/// requirements once more, written down as plainly as possible and without any shortcut, to compare
/// the validator with.
std::vector<core::Check> reference_failures(std::span<const Point> state,
                                            const std::vector<geometry::Box>& boxes, double e);

}  // namespace asv::test
