#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace asv::core {

/// Calls work(0) to work(count - 1), the first in this thread, each other one in a thread of its
/// own, and returns when all have ended.
///
/// What any of them throws is thrown here, the first of several; stop is requested for the others
/// then. No thread is started once stop is requested (somebody has won already), nor when the
/// system grants no more: those that there are have to do.
void in_threads(std::size_t count, std::stop_source stop,
                const std::function<void(std::size_t)>& work);

}  // namespace asv::core
