#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asv::tools {

/// How another program ended.
struct SupervisedEnd {
    int status = 0;               ///< as wait() has it
    bool timed_out = false;       ///< it was killed, since its time was over
    bool called_off = false;      ///< it was killed, since nobody waits for it any more
    double seconds = 0;           ///< from its start to its end, wall clock
    std::size_t peak_memory = 0;  ///< bytes, resident, of its largest process
    std::string last_words;       ///< the last line that it wrote to standard error
};

/// Holds back the signals that run_supervised() waits for; SIGTERM calls it off. Precondition: this
/// process has one thread.
void hold_signals_of_supervision();

/// Runs the program (looked for as a shell does) with these arguments and waits for it: at most so
/// many seconds, then it is killed, with all processes of its group. Its standard input is empty,
/// its standard output goes nowhere. 0 megabytes are no limit of memory. Throws std::system_error
/// where the system grants no process. Precondition: hold_signals_of_supervision().
SupervisedEnd run_supervised(const std::vector<std::string>& words, double most_seconds,
                             std::size_t megabytes);

/// Is there such a program to run?
bool is_program(const std::string& name);

}  // namespace asv::tools
