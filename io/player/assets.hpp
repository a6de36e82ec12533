#pragma once

#include <string_view>

/// The parts of the player as they stand in this folder, put into the program when it is built.
namespace asv::io::assets {

extern const std::string_view page;     ///< player.html, with places for the other parts
extern const std::string_view gallery;  ///< gallery.html, with places for the cards
extern const std::string_view style;    ///< player.css
extern const std::string_view script;   ///< the .js files, one after the other

}  // namespace asv::io::assets
