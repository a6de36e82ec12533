#pragma once

#include <cstddef>
#include <string>

#include <sys/resource.h>

/// How the process of a run may end, and the memory that it may have.

namespace asv::tools {

/// From here on this process, and those that it starts, may have so many megabytes of memory each;
/// where it wants more by `new`, it ends, as ran_out_of_memory() knows. 0 is no limit. What counts
/// is the private memory that may be written to (RLIMIT_DATA): address space that is only reserved,
/// as garbage collectors do, is free.
void limit_memory(std::size_t megabytes);

/// Has the process ended for lack of memory? One of ours says so by its exit code; another program
/// is taken at its peak, bytes resident: it has failed, and it came near to the limit. `status` is
/// that of wait(); megabytes of 0 are no limit.
bool ran_out_of_memory(int status, std::size_t peak_memory, std::size_t megabytes);

/// "it wanted more than 100 MB of memory".
std::string memory_reason(std::size_t megabytes);

/// "was ended by signal 11 (Segmentation fault)", "ended with exit code 3".
std::string how_it_ended(int status);

/// The most that a process that has ended has held, resident, in bytes.
std::size_t peak_memory(const rusage& used);

}  // namespace asv::tools
