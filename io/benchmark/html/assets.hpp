#pragma once

#include <string_view>

/// The parts of the page of a benchmark, put into the program when it is built.
namespace asv::io::report_assets {

extern const std::string_view page;     ///< report.html, with places for the other parts
extern const std::string_view style;    ///< report.css
extern const std::string_view script;   ///< charts.js
extern const std::string_view library;  ///< Chart.js; empty where the build had none

}  // namespace asv::io::report_assets
