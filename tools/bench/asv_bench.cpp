#include <memory>

#include "tools/bench/bench_program.hpp"
#include "tools/bench/runs/run_launcher.hpp"
#include "tools/common/command_line.hpp"
#include "tools/common/mpi_launch.hpp"

int main(int argc, char** argv) try {
    using namespace asv;
    if (const auto code = tools::hand_over_to_mpi("asv-bench", argv)) return *code;
    return tools::run_bench_program(argc, argv, {[](const core::BenchmarkPlan& plan) {
                                        return std::make_unique<tools::RunLauncher>(plan);
                                    }});
} catch (...) {
    return asv::tools::report_failed_start("asv-bench");
}
