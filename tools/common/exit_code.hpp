#pragma once

namespace asv::tools {

/// What every program tells its caller.
enum class ExitCode : int {
    done = 0,           ///< solved; valid
    no = 1,             ///< not solved in the time given; not valid
    usage = 2,          ///< wrong arguments
    bad_input = 3,      ///< an input cannot be read or understood, or its start or goal is invalid
    infeasible = 4,     ///< proven to have no solution
    bad_output = 5,     ///< an output cannot be written
    internal = 70,      ///< a bug, or no memory
    interrupted = 130,  ///< by the user, with nothing to show
};

}  // namespace asv::tools
