#include "io/drawing/paint/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include "io/drawing/paint/svg_text.hpp"
#include "io/text/markup.hpp"
#include "io/text/valid_text.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

constexpr const char* font_family = "sans-serif";

/// cairo computes where all lines of one path cross each other, so thousands are drawn in parts.
constexpr std::size_t shapes_per_path = 256;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_SUCCESS) return;
    throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

cairo_surface_t* make_surface(PictureFormat format, double width, double height,
                              double pixels_per_point, std::string& bytes) {
    switch (format) {
        case PictureFormat::svg:
            return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
        case PictureFormat::pdf:
            return cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
        case PictureFormat::png: {
            const auto pixels = [&](double points) {
                return static_cast<int>(std::lround(points * pixels_per_point));
            };
            return cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height));
        }
    }
    throw std::invalid_argument("format: not a picture format");
}

void round_lines(cairo_t* cairo) {
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
}

}  // namespace

struct Canvas::Handles {
    struct FreeSurface {
        void operator()(cairo_surface_t* freed) const { cairo_surface_destroy(freed); }
    };
    struct FreeContext {
        void operator()(cairo_t* freed) const { cairo_destroy(freed); }
    };
    std::unique_ptr<cairo_surface_t, FreeSurface> surface;
    std::unique_ptr<cairo_t, FreeContext> context;
    std::unique_ptr<cairo_t, FreeContext> pixels;  ///< only between push_pixels and pop_pixels
    Point pixels_at;
};

Canvas::Canvas(PictureFormat format, double width, double height, double pixels_per_point)
    : format_(format), pixels_per_point_(pixels_per_point), handles_(std::make_unique<Handles>()) {
    handles_->surface.reset(make_surface(format, width, height, pixels_per_point, bytes_));
    check(cairo_surface_status(handles_->surface.get()));
    // A point of cairo's svg is one px of the reader's screen, as it is in the html player.
    if (format == PictureFormat::svg) {
        cairo_svg_surface_set_document_unit(handles_->surface.get(), CAIRO_SVG_UNIT_PX);
    }
    handles_->context.reset(cairo_create(handles_->surface.get()));
    cairo_ = handles_->context.get();
    check(cairo_status(cairo_));
    if (format == PictureFormat::png) cairo_scale(cairo_, pixels_per_point, pixels_per_point);
    round_lines(cairo_);
}

Canvas::~Canvas() = default;

namespace {

void use(cairo_t* cairo, const Colour& colour) {
    cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, colour.alpha);
}

void trace_box(cairo_t* cairo, const Box& box) {
    cairo_rectangle(cairo, box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
}

void trace_segment(cairo_t* cairo, const Segment& segment) {
    cairo_move_to(cairo, segment.a.x, segment.a.y);
    cairo_line_to(cairo, segment.b.x, segment.b.y);
}

void trace_dot(cairo_t* cairo, const Point& centre) {
    cairo_move_to(cairo, centre.x, centre.y);
    cairo_close_path(cairo);
}

template <class Shape, class Trace, class Paint>
void for_each_part(cairo_t* cairo, std::span<const Shape> shapes, const Trace& trace,
                   const Paint& paint) {
    while (!shapes.empty()) {
        const std::size_t count = std::min(shapes.size(), shapes_per_path);
        for (const Shape& shape : shapes.first(count)) trace(cairo, shape);
        paint(cairo);
        shapes = shapes.subspan(count);
    }
}

}  // namespace

void Canvas::apply(const Stroke& stroke) {
    use(cairo_, stroke.colour);
    cairo_set_line_width(cairo_, stroke.width);
    cairo_set_dash(cairo_, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0);
}

void Canvas::apply(const TextStyle& style) {
    use(cairo_, style.colour);
    cairo_select_font_face(cairo_, font_family, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, style.size);
}

void Canvas::trace(std::span<const Point> points) {
    for (const Point& point : points) cairo_line_to(cairo_, point.x, point.y);
}

void Canvas::fill_all(const Colour& colour) {
    use(cairo_, colour);
    cairo_paint(cairo_);
}

void Canvas::fill_boxes(std::span<const Box> boxes, const Colour& colour) {
    use(cairo_, colour);
    for_each_part(cairo_, boxes, trace_box, cairo_fill);
}

void Canvas::stroke_boxes(std::span<const Box> boxes, const Stroke& stroke) {
    apply(stroke);
    for_each_part(cairo_, boxes, trace_box, cairo_stroke);
}

void Canvas::fill_polygon(std::span<const Point> points, const Colour& colour) {
    use(cairo_, colour);
    trace(points);
    cairo_close_path(cairo_);
    cairo_fill(cairo_);
}

void Canvas::stroke_line(std::span<const Point> points, const Stroke& stroke) {
    apply(stroke);
    trace(points);
    cairo_stroke(cairo_);
}

void Canvas::stroke_segments(std::span<const Segment> segments, const Stroke& stroke) {
    apply(stroke);
    for_each_part(cairo_, segments, trace_segment, cairo_stroke);
}

void Canvas::fill_dots(std::span<const Point> centres, double radius, const Colour& colour) {
    // A line without length has round ends alone.
    apply(Stroke{colour, 2 * radius});
    for_each_part(cairo_, centres, trace_dot, cairo_stroke);
}

void Canvas::fill_circle(const Point& centre, double radius, const Colour& colour) {
    use(cairo_, colour);
    cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_fill(cairo_);
}

void Canvas::stroke_circle(const Point& centre, double radius, const Stroke& stroke) {
    apply(stroke);
    cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(cairo_);
}

void Canvas::text(const Point& at, std::string_view words, const TextStyle& style) {
    if (format_ == PictureFormat::svg) {
        svg_texts_ += svg_text(at, words, style);
        return;
    }
    const double width = text_width(words, style);
    const double shift = style.align == Align::left     ? 0
                         : style.align == Align::centre ? width / 2
                                                        : width;
    cairo_move_to(cairo_, at.x - shift, at.y);
    cairo_show_text(cairo_, valid_text(words).c_str());
    cairo_new_path(cairo_);
}

double Canvas::text_width(std::string_view words, const TextStyle& style) {
    apply(style);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, valid_text(words).c_str(), &extents);
    return extents.x_advance;
}

void Canvas::push_clip(const Box& box) {
    cairo_save(cairo_);
    trace_box(cairo_, box);
    cairo_clip(cairo_);
}

void Canvas::push_clip_circle(const Point& centre, double radius) {
    cairo_save(cairo_);
    cairo_arc(cairo_, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
    cairo_clip(cairo_);
}

void Canvas::pop_clip() {
    cairo_restore(cairo_);
}

void Canvas::push_pixels(const Box& box) {
    if (format_ == PictureFormat::png) return;
    const auto pixels = [&](double points) {
        return static_cast<int>(std::ceil(points * pixels_per_point_));
    };
    cairo_surface_t* image = cairo_image_surface_create(
        CAIRO_FORMAT_ARGB32, pixels(box.high.x - box.low.x), pixels(box.high.y - box.low.y));
    handles_->pixels.reset(cairo_create(image));
    cairo_surface_destroy(image);  // the context keeps it
    handles_->pixels_at = box.low;
    cairo_ = handles_->pixels.get();
    cairo_scale(cairo_, pixels_per_point_, pixels_per_point_);
    cairo_translate(cairo_, -box.low.x, -box.low.y);
    round_lines(cairo_);
}

void Canvas::pop_pixels() {
    if (format_ == PictureFormat::png) return;
    check(cairo_status(cairo_));
    cairo_ = handles_->context.get();
    cairo_save(cairo_);
    cairo_translate(cairo_, handles_->pixels_at.x, handles_->pixels_at.y);
    cairo_scale(cairo_, 1 / pixels_per_point_, 1 / pixels_per_point_);
    cairo_set_source_surface(cairo_, cairo_get_target(handles_->pixels.get()), 0, 0);
    cairo_paint(cairo_);
    cairo_restore(cairo_);
    handles_->pixels.reset();
}

std::string Canvas::finish(std::string_view title, std::string_view description) {
    check(cairo_status(cairo_));
    cairo_surface_t* surface = handles_->surface.get();
    if (format_ == PictureFormat::pdf) {
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE,
                                       valid_text(title).c_str());
    }
    if (format_ == PictureFormat::png) {
        check(cairo_surface_write_to_png_stream(surface, append, &bytes_));
    }
    cairo_surface_finish(surface);
    check(cairo_surface_status(surface));
    // cairo writes six decimals of every number; a hundredth of a point is more than a screen
    // shows, and takes a quarter less.
    if (format_ == PictureFormat::svg) {
        bytes_ = with_two_decimals(bytes_);
        add_svg_texts(bytes_, svg_texts_);
        describe_svg(bytes_, title, description);
    }
    return std::move(bytes_);
}

}  // namespace asv::io
