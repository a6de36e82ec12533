// Eigen's vector code for SSE2 includes this header and uses nothing of it; Emscripten has none.
#pragma once
