#pragma once

#include <cstddef>
#include <string>

#include "io/drawing/exhibit.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/palette.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// Pictures of a body on its way, one after the other: the field with start, goal and the paths of
/// all points, and in front of them the body where it is at that time.
class Animation {
  public:
    /// So many pictures, evenly in primitive steps: the first of the start, the last of the goal.
    /// The longer side of the field has 800 pixels. Preconditions: the exhibit has a solution and
    /// outlives the animation; there are 2 pictures or more.
    Animation(const Exhibit& exhibit, Theme theme, std::size_t pictures);

    std::size_t size() const { return pictures_; }

    /// The bytes of picture 0 to size() - 1, a png. Throws std::runtime_error when cairo fails.
    std::string picture(std::size_t index) const;

  private:
    std::size_t state_of(std::size_t index) const;

    const Exhibit& exhibit_;
    const Palette& colours_;
    std::size_t pictures_;
    Scene scene_;  ///< what is behind the body
    Page page_;
};

}  // namespace asv::io
