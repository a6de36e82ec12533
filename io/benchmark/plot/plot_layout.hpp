#pragma once

namespace asv::io {

/// How the parts of a picture lie, and how wide it is therefore.
enum class PlotLayout {
    wide,   ///< for a screen or a whole page: side by side, below a heading
    column  ///< for a column of print, 8 or 9 cm: one below the other, the heading left to a
            ///< caption
};

}  // namespace asv::io
