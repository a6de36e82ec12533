#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace asv::tools {

/// While it lives, the program does not outlast a moment, whatever it is doing then: reading a file
/// or indexing obstacles cannot be asked to stop.
class TimeLimitWatch {
  public:
    /// give_up is called from a thread of its own at that moment and has to end the process.
    TimeLimitWatch(std::chrono::steady_clock::time_point moment, std::function<void()> give_up);
    TimeLimitWatch(const TimeLimitWatch&) = delete;
    TimeLimitWatch& operator=(const TimeLimitWatch&) = delete;

  private:
    std::jthread watcher_;
};

}  // namespace asv::tools
