#include "tools/common/mpi_launch.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include <unistd.h>

#include "tools/common/exit_code.hpp"

namespace asv::tools {

namespace {

/// The variables in which launchers tell how many processes they have started, and the number of
/// this one.
struct Launcher {
    const char* processes;
    const char* rank;
};
constexpr std::array<Launcher, 3> launchers{{
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},  // mpirun of Open MPI
    {"PMI_SIZE", "PMI_RANK"},                          // mpirun of MPICH, srun --mpi=pmi2
    {"SLURM_STEP_NUM_TASKS", "PMIX_RANK"},             // srun --mpi=pmix
}};

/// The first launcher that has left its variables; nullptr where none has.
const Launcher* launcher_of_this() {
    for (const Launcher& launcher : launchers)
        if (std::getenv(launcher.processes) != nullptr && std::getenv(launcher.rank) != nullptr)
            return &launcher;
    return nullptr;
}

}  // namespace

std::optional<int> hand_over_to_mpi(const char* program, char** argv) {
    const Launcher* launcher = launcher_of_this();
    if (launcher == nullptr || std::atoi(std::getenv(launcher->processes)) <= 1)
        return std::nullopt;
    std::error_code no_link;
    const std::string name = std::string(program) + "-mpi";
    const auto sibling =
        std::filesystem::read_symlink("/proc/self/exe", no_link).parent_path() / name;
    ::execv(sibling.c_str(), argv);
    if (std::strcmp(std::getenv(launcher->rank), "0") != 0) return static_cast<int>(ExitCode::done);
    std::cerr << program << ": started by a launcher of MPI, but built without MPI: there is no "
              << sibling.string() << " (docs/mpi.md)\n";
    return static_cast<int>(ExitCode::usage);
}

void forget_mpi_launch() {
    for (const Launcher& launcher : launchers) ::unsetenv(launcher.rank);
}

}  // namespace asv::tools
