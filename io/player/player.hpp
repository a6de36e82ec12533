#pragma once

#include <string>

#include "io/drawing/exhibit.hpp"

namespace asv::io {

/// The player for an exhibit: one HTML page that needs nothing else, no network, no other file.
/// Its read-outs are exact: cost, clearance, area and turns are computed here and carried as
/// doubles, and violations are the validator's own. Positions, which only place the drawing, are
/// carried to half of 1e-10 of the field's size. Of a path whose states would take more than 3.5 MB
/// it holds those that held_states() chooses, and says so. Without a solution it shows start and
/// goal.
std::string make_player(const Exhibit& exhibit);

}  // namespace asv::io
