#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "core/benchmark/run.hpp"

namespace asv::tools {

/// A process that starts the processes of runs. It answers questions: blocks of bytes go in, blocks
/// come out, over a socket. It ends with the process that has made it.
///
/// A process that is forked beside threads inherits their locks, which nobody opens any more; so
/// this one is forked while there are no threads, and forks the runs.
class LauncherProcess {
  public:
    /// Forks; serve is called in the new process with its end of the socket, which it alone has
    /// open but for the standard streams. Throws std::system_error where the system grants no
    /// process. Precondition: no thread has been started.
    explicit LauncherProcess(const std::function<void(int socket)>& serve);
    ~LauncherProcess();
    LauncherProcess(const LauncherProcess&) = delete;
    LauncherProcess& operator=(const LauncherProcess&) = delete;

    /// Sends a block that has no answer. False where the process has ended.
    bool tell(std::string_view block) const;

    /// The answer to a block; none where the process has ended. It is killed, with the run that it
    /// has started, once `abandoned`, which is asked a hundred times a second, says so.
    std::optional<std::string> ask(std::string_view block,
                                   const std::function<bool()>& abandoned) const;

  private:
    pid_t id_ = 0;
    int socket_ = -1;
};

/// The next block that has come; none when the other end is closed.
std::optional<std::string> read_block(int socket);

/// What the launcher process of a plan serves: the bytes of the place of a run (run_bytes.hpp) are
/// the question, those of the run the answer. Each run is core::run_once(), or run_external(), in a
/// process of its own, and has its peak memory filled in; a process that ends in any other way than
/// by itself is a fault of the run. Returns when the other end is closed.
void serve_runs(const core::BenchmarkPlan& plan, int socket);

/// The answer as a run of this place; one with a fault where there is none.
core::BenchmarkRun answered_run(const std::optional<std::string>& answer,
                                const core::RunPlace& place);

}  // namespace asv::tools
