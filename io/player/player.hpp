#pragma once

#include <string>

#include "io/drawing/exhibit.hpp"

namespace asv::io {

/// The player for an exhibit: one HTML page that needs nothing else, no network, no other file.
/// Its read-outs are exact: cost, clearance, area and turns are computed here and carried as
/// doubles, and violations are the validator's own. Positions, which only place the drawing, are
/// carried to half of 1e-10 of the field's size. Without a solution it shows start and goal.
std::string make_player(const Exhibit& exhibit);

}  // namespace asv::io
