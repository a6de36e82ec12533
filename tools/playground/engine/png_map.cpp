// PNG pictures as maps without libpng, which is not there for WebAssembly. Other than libpng, this
// reader knows nothing of colour profiles and takes the colours as they are.

#include "io/map/png_map.hpp"

#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

#include "io/map/words.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

bool is_png(std::string_view content) {
    return content.starts_with("\x89PNG");
}

geometry::Grid parse_png(std::string_view content, const std::string& name,
                         const OccupiedGreys& greys) {
    constexpr int colours = 4;  // red, green, blue, opacity
    constexpr double opaque = 255;
    int width = 0, height = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(content.data()),
                              static_cast<int>(content.size()), &width, &height, nullptr, colours),
        stbi_image_free);
    if (!pixels) throw ParseError(name, 1, 1, "a PNG picture", stbi_failure_reason());
    geometry::Grid grid =
        MapWords({}, name, false)
            .make_grid(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
    const stbi_uc* pixel = pixels.get();
    fill(grid, [&] {
        const double share = pixel[3] / opaque;
        const double brightness = share * luma(pixel[0], pixel[1], pixel[2]) + (1 - share) * opaque;
        pixel += colours;
        return static_cast<std::uint8_t>(greys.hold(brightness));
    });
    return grid;
}

}  // namespace asv::io
