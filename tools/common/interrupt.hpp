#pragma once

#include <stop_token>
#include <thread>

namespace asv::tools {

/// While it lives, Ctrl-C and SIGTERM ask for a stop instead of ending the process.
/// Precondition: made before any other thread, so that all of them leave the signals alone.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    std::stop_token token() const { return interrupted_.get_token(); }
    /// Asked for a second time.
    std::stop_token again() const { return again_.get_token(); }

  private:
    std::stop_source interrupted_, again_;
    std::jthread watcher_;
};

}  // namespace asv::tools
