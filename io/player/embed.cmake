# cmake -DOUTPUT=FILE.cpp -DFOLDER=DIR -P embed.cmake
#
# Writes the parts of the player into one C++ source, as raw string literals of a few kilobytes
# each, which every compiler takes; adjacent ones are joined by it. They are cut at line ends.

set(piece_length 8000)

function(append_literal name)
  set(text "")
  foreach(part IN LISTS ARGN)
    file(READ ${FOLDER}/${part} content)
    string(APPEND text "${content}")
  endforeach()
  set(literal "")
  string(LENGTH "${text}" rest)
  while(rest GREATER 0)
    string(SUBSTRING "${text}" 0 ${piece_length} piece)
    if(rest GREATER piece_length)
      string(FIND "${piece}" "\n" end REVERSE)
      math(EXPR end "${end} + 1")
      string(SUBSTRING "${text}" 0 ${end} piece)
    endif()
    string(LENGTH "${piece}" used)
    string(SUBSTRING "${text}" ${used} -1 text)
    string(LENGTH "${text}" rest)
    string(APPEND literal "\n    R\"asset(${piece})asset\"")
  endwhile()
  file(APPEND ${OUTPUT}.new "const std::string_view ${name} =${literal};\n\n")
endfunction()

file(WRITE ${OUTPUT}.new "#include \"io/player/assets.hpp\"\n\nnamespace asv::io::assets {\n\n")
append_literal(page player.html)
append_literal(gallery gallery.html)
append_literal(style player.css)
append_literal(script data.js camera.js field.js moving.js plots.js playback.js legend.js controls.js)
file(APPEND ${OUTPUT}.new "}  // namespace asv::io::assets\n")
file(RENAME ${OUTPUT}.new ${OUTPUT})
