#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/drawing/animation.hpp"

namespace asv::tools {

enum class FilmFormat { gif, mp4, webm };

/// By the ending of a file's name (".gif"); none for any other.
std::optional<FilmFormat> film_format(std::string_view ending);

/// The bytes of a film that shows so many pictures a second, made by the program ffmpeg. The first
/// and the last one stay for half a second. Throws UsageError where there is no such program, and
/// std::runtime_error with its last words where it fails.
std::string make_film(const io::Animation& animation, FilmFormat format,
                      unsigned pictures_per_second);

}  // namespace asv::tools
