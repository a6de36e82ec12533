#include "io/map/png_map.hpp"

#include <vector>

#include <png.h>

#include "io/map/words.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

/// A PNG picture as libpng reads it; what it holds is given back on every way out.
struct PngReader {
    png_image image{};

    PngReader() { image.version = PNG_IMAGE_VERSION; }
    ~PngReader() { png_image_free(&image); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

}  // namespace

bool is_png(std::string_view content) {
    return content.starts_with("\x89PNG");
}

geometry::Grid parse_png(std::string_view content, const std::string& name,
                         const OccupiedGreys& greys) {
    PngReader reader;
    const auto require = [&](int done) {
        if (done == 0) throw ParseError(name, 1, 1, "a PNG picture", reader.image.message);
    };
    require(png_image_begin_read_from_memory(&reader.image, content.data(), content.size()));
    geometry::Grid grid =
        MapWords({}, name, false).make_grid(reader.image.width, reader.image.height);
    // 8 bits for each colour, whatever it had, on white.
    reader.image.format = PNG_FORMAT_RGB;
    const png_color white{255, 255, 255};
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(reader.image));
    require(png_image_finish_read(&reader.image, &white, pixels.data(), 0, nullptr));
    const unsigned char* pixel = pixels.data();
    fill(grid, [&] {
        const double brightness = luma(pixel[0], pixel[1], pixel[2]);
        pixel += 3;
        return static_cast<std::uint8_t>(greys.hold(brightness));
    });
    return grid;
}

}  // namespace asv::io
