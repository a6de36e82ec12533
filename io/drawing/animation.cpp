#include "io/drawing/animation.hpp"

#include <vector>

#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/field_painter.hpp"

namespace asv::io {

namespace {

/// What stands still: the scene without the stops of the body between start and goal.
Scene still_scene(const Exhibit& exhibit) {
    Scene scene = make_scene(exhibit);
    std::erase_if(scene.lines, [](const SceneLine& line) {
        return line.role == Role::ghost || line.role == Role::ghost_closing;
    });
    return scene;
}

}  // namespace

Animation::Animation(const Exhibit& exhibit, Theme theme, std::size_t pictures)
    : exhibit_(exhibit),
      colours_(palette(theme)),
      pictures_(pictures),
      scene_(still_scene(exhibit)),
      page_(Page::of_field(scene_.field, Page::field_side)) {}

std::size_t Animation::state_of(std::size_t index) const {
    const std::size_t last = exhibit_.solution->path.size() - 1;
    const double share = static_cast<double>(index) / static_cast<double>(pictures_ - 1);
    return static_cast<std::size_t>(share * static_cast<double>(last) + 0.5);
}

std::string Animation::picture(std::size_t index) const {
    const std::size_t state = state_of(index);
    const auto points = exhibit_.solution->path.state(state);
    const double total = exhibit_.measures.back().cost;
    const double progress = total == 0 ? 0 : exhibit_.measures[state].cost / total;
    constexpr double pixels_per_point = 1;
    Canvas canvas(PictureFormat::png, page_.width, page_.height, pixels_per_point);
    paint_bare_field(canvas, scene_, page_, colours_);
    canvas.push_clip(page_.field);
    paint_body(canvas, page_.at(std::vector(points.begin(), points.end())), colours_,
               along_the_way(colours_, progress));
    canvas.pop_clip();
    return canvas.finish(exhibit_.name, {});
}

}  // namespace asv::io
