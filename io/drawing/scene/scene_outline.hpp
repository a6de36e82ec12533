#pragma once

#include <string>
#include <string_view>

#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// "path", "ghost closing", ...
std::string_view name(Role role);

/// One line of text for each thing in the scene, coordinates with 4 digits: for tests and for
/// comparing two pictures by diff.
std::string outline(const Scene& scene);

}  // namespace asv::io
