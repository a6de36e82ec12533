#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/primitives.hpp"
#include "io/drawing/paint/palette.hpp"

typedef struct _cairo cairo_t;

namespace asv::io {

enum class PictureFormat { svg, png, pdf };

/// How a line looks; lengths in points of the page, above 0.
struct Stroke {
    Colour colour;
    double width = 1;                 ///< a thin line
    std::vector<double> dashes = {};  ///< lengths of dash and gap; empty: a full line
};

enum class Align { left, centre, right };

/// How text looks.
struct TextStyle {
    Colour colour;
    double size = 13;           ///< of the letters in points of the page, above 0; by eye
    bool bold = false;          ///< plain unless asked for
    Align align = Align::left;  ///< as one reads
};

/// A page to draw on, in points from the upper left, y downwards. The only file that knows cairo.
/// Throws std::runtime_error when cairo fails (out of memory, or a picture beyond its size limit).
class Canvas {
  public:
    /// pixels_per_point matters for png alone; the other formats have no pixels.
    Canvas(PictureFormat format, double width, double height, double pixels_per_point);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void fill_all(const Colour& colour);
    void fill_boxes(std::span<const geometry::Box> boxes, const Colour& colour);
    void stroke_boxes(std::span<const geometry::Box> boxes, const Stroke& stroke);
    void fill_polygon(std::span<const geometry::Point> points, const Colour& colour);
    void stroke_line(std::span<const geometry::Point> points, const Stroke& stroke);
    void stroke_segments(std::span<const geometry::Segment> segments, const Stroke& stroke);
    /// Equal discs. In a file they take a fifth of the bytes that as many circles need.
    void fill_dots(std::span<const geometry::Point> centres, double radius, const Colour& colour);
    void fill_circle(const geometry::Point& centre, double radius, const Colour& colour);
    void stroke_circle(const geometry::Point& centre, double radius, const Stroke& stroke);

    /// at is on the base line, at the side that the style aligns to. In an svg it is text that can
    /// be selected and searched; there it stands in front of everything else, and is not clipped.
    void text(const geometry::Point& at, std::string_view words, const TextStyle& style);
    double text_width(std::string_view words, const TextStyle& style);

    /// Until the matching pop, nothing outside the box or circle is drawn.
    void push_clip(const geometry::Box& box);
    void push_clip_circle(const geometry::Point& centre, double radius);
    void pop_clip();

    /// Until the matching pop, what is drawn in the box becomes one image, with as many pixels for
    /// a point as a png has, also in formats of lines: a million shapes would make a file that
    /// nobody can open. Not to be nested.
    void push_pixels(const geometry::Box& box);
    void pop_pixels();

    /// The file's bytes; nothing can be drawn after it. In an svg, title and description become
    /// its accessible name and text.
    std::string finish(std::string_view title, std::string_view description);

  private:
    struct Handles;
    void apply(const Stroke& stroke);
    void apply(const TextStyle& style);
    void trace(std::span<const geometry::Point> points);

    PictureFormat format_;
    double pixels_per_point_;
    std::string bytes_;
    std::string svg_texts_;  ///< the elements of an svg that finish() adds
    std::unique_ptr<Handles> handles_;
    cairo_t* cairo_;
};

}  // namespace asv::io
