#pragma once

#include <optional>

/// The programs beside MPI: they do not know it, but notice that its launcher has started them.

namespace asv::tools {

/// Where a launcher of MPI (mpirun, srun) has started several processes of this program, the
/// process becomes the one of the same folder that is called PROGRAM-mpi, and this does not return.
/// Where there is none, says so, one process for all, and returns the exit code of the process.
/// Returns none where no launcher has started several.
std::optional<int> hand_over_to_mpi(const char* program, char** argv);

/// From here on this process, and those that it starts, do not count as started by such a launcher.
void forget_mpi_launch();

}  // namespace asv::tools
