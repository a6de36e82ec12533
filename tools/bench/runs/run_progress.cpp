#include "tools/bench/runs/run_progress.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

namespace asv::tools {

namespace {

std::string seconds_text(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 120) return std::to_string(whole) + " s";
    if (whole < 7200) return std::to_string(whole / 60) + " min";
    return std::to_string(whole / 3600) + " h";
}

}  // namespace

void RunProgress::begin(const core::RunPlace& place) {
    const double elapsed = std::chrono::duration<double>(core::Clock::now() - begun_).count();
    std::string text =
        std::to_string(done_ + 1) + " of " + std::to_string(runs_) + ": " +
        plan_.problems[place.problem].name + ", " + plan_.planners[place.planner].label + ", " +
        std::string(core::name(place.direction)) + ", seed " + std::to_string(place.seed);
    if (done_ > 0) {
        const auto left = static_cast<double>(runs_ - done_);
        text += ", about " + seconds_text(elapsed / static_cast<double>(done_) * left) + " left";
    }
    line_.show(text);
}

void RunProgress::tell(const std::string& text) {
    line_.clear();
    std::cerr << text << '\n';
}

}  // namespace asv::tools
