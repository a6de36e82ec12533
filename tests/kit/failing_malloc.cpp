#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

/// Preloaded into a program (LD_PRELOAD), fails its allocation number ASV_FAILING_ALLOCATION, and
/// no other; counted from the moment that this library is ready.

// What the C library calls its own.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
}

namespace {

std::atomic<long> until_failure = 0;

__attribute__((constructor)) void begin() {
    const char* number = std::getenv("ASV_FAILING_ALLOCATION");
    if (number) until_failure = std::atol(number);
}

bool fails() {
    if (until_failure <= 0 || until_failure.fetch_sub(1) != 1) return false;
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
    return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    return fails() ? nullptr : __libc_realloc(memory, size);
}
}
