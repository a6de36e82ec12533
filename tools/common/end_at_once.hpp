#pragma once

#include <unistd.h>

#ifdef ASV_COUNTS_COVERAGE
extern "C" {
#include <gcov.h>
}
#endif

namespace asv::tools {

/// Ends the process without undoing or flushing anything. Not for handlers of signals: where gcov
/// counts (preset coverage), this writes the counts, which otherwise only an ordinary end does.
[[noreturn]] inline void end_at_once(int exit_code) {
#ifdef ASV_COUNTS_COVERAGE
    // The time of end_anyway_after() does not last for that.
    ::alarm(0);
    ::__gcov_dump();
#endif
    ::_exit(exit_code);
}

}  // namespace asv::tools
