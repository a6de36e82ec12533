#include "io/benchmark/table/table.hpp"

#include "io/benchmark/table/report_text.hpp"

namespace asv::io {

std::string markdown_table(const BenchmarkReport& report, const Columns& columns) {
    return markdown(report_text(report, columns));
}

std::string latex_table(const BenchmarkReport& report, const Columns& columns) {
    return latex(report_text(report, columns));
}

}  // namespace asv::io
