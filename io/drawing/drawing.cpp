#include "io/drawing/drawing.hpp"

#include "io/drawing/paint/field_painter.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/strip_painter.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

namespace {

constexpr double title_size = 22;
constexpr double png_pixels_per_point = 2;
constexpr double thumbnail_side = 400;

/// The words, or as much of them as fits with an ellipsis behind.
std::string fitted(Canvas& canvas, std::string words, const TextStyle& style, double width) {
    if (canvas.text_width(words, style) <= width) return words;
    while (!words.empty() && canvas.text_width(words + "…", style) > width) {
        // A character of UTF-8 ends where the byte before is not a continuation.
        while (words.size() > 1 && (static_cast<unsigned char>(words.back()) & 0xC0) == 0x80) {
            words.pop_back();
        }
        words.pop_back();
    }
    return words + "…";
}

void paint_header(Canvas& canvas, const Exhibit& exhibit, const std::vector<std::string>& sentences,
                  const Page& page, const Palette& colours) {
    const double width = page.width - Page::left - Page::right;
    const bool good = sentences.empty();
    const TextStyle mark{good ? colours.goal : colours.violation, Page::text_size, true,
                         Align::right};
    const std::string judgement = (good ? "✓ " : "✗ ") + verdict(exhibit);
    canvas.text({page.width - Page::right, 32}, judgement, mark);
    const TextStyle title{colours.ink, title_size, true};
    const double title_width = width - canvas.text_width(judgement, mark) - 20;
    canvas.text({Page::left, 34}, fitted(canvas, exhibit.name, title, title_width), title);
    const TextStyle plain{colours.muted, Page::text_size};
    double y = 58;
    canvas.text({Page::left, y}, fitted(canvas, facts(exhibit), plain, width), plain);
    const TextStyle alarm{colours.violation, Page::text_size};
    for (const std::string& sentence : sentences) {
        y += Page::line_height;
        canvas.text({Page::left, y}, fitted(canvas, sentence, alarm, width), alarm);
    }
}

}  // namespace

std::string draw_picture(const Exhibit& exhibit, PictureFormat format, Theme theme) {
    const Palette& colours = palette(theme);
    const Scene scene = make_scene(exhibit);
    const std::vector<std::string> sentences = complaints(exhibit);
    const Page page(scene.field, sentences.size(), strip_height(exhibit, scene));
    Canvas canvas(format, page.width, page.height, png_pixels_per_point);
    canvas.fill_all(colours.page);
    paint_header(canvas, exhibit, sentences, page, colours);
    paint_field(canvas, scene, page, colours);
    paint_strip(canvas, exhibit, scene, page, colours);
    return canvas.finish(exhibit.name, facts(exhibit) + "; " + verdict(exhibit));
}

std::string draw_thumbnail(const Exhibit& exhibit, Theme theme) {
    const Scene scene = make_scene(exhibit);
    const Page page = Page::of_field(scene.field, thumbnail_side);
    Canvas canvas(PictureFormat::svg, page.width, page.height, png_pixels_per_point);
    paint_bare_field(canvas, scene, page, palette(theme));
    return canvas.finish(exhibit.name, facts(exhibit) + "; " + verdict(exhibit));
}

}  // namespace asv::io
