#pragma once

#include <string_view>

#include "core/model/problem.hpp"
#include "io/text/parse_error.hpp"

/// What several kinds of input promise.

namespace asv::fuzz {

/// Throws std::logic_error with these words where a promise is not kept.
void require(bool kept, std::string_view promise);

/// An error names a place that is in the text, or right behind it.
void require_place_in(std::string_view text, const io::ParseError& error);

/// The invariant of core::Problem.
void require_sound(const core::Problem& problem);

}  // namespace asv::fuzz
