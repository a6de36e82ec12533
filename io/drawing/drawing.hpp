#pragma once

#include <string>

#include "io/drawing/exhibit.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// The bytes of one picture. The longer side of the field is 800 points in every picture, so that
/// problems of one size have one scale; a png has two pixels for each point. The page is as
/// high as its text needs. Throws std::runtime_error when cairo fails.
std::string draw_picture(const Exhibit& exhibit, PictureFormat format, Theme theme);

/// An svg of the field alone for a list of many: what draw_picture shows in it without grid,
/// numbers and words, its longer side 400 points. Throws std::runtime_error when cairo fails.
std::string draw_thumbnail(const Exhibit& exhibit, Theme theme);

}  // namespace asv::io
