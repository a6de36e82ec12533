#include "tools/common/progress_line.hpp"

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace asv::tools {

ProgressLine::ProgressLine(bool wanted) : visible_(wanted && ::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const std::string& text) {
    if (!visible_) return;
    const std::size_t blanks = drawn_ > text.size() ? drawn_ - text.size() : 0;
    std::cerr << '\r' << text << std::string(blanks, ' ') << std::flush;
    drawn_ = text.size();
}

void ProgressLine::clear() {
    if (drawn_ == 0) return;
    std::cerr << '\r' << std::string(drawn_, ' ') << '\r' << std::flush;
    drawn_ = 0;
}

}  // namespace asv::tools
