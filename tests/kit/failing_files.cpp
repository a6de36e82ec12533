#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

/// Preloaded into a program (LD_PRELOAD), fails one of its calls that open, write, flush, link or
/// rename a file: that of number ASV_FAILING_FILE_CALL, counted over all of them; with
/// ASV_FAILING_FROM_THERE_ON all later ones as well. With ASV_SHORT_WRITES each write takes three
/// bytes at most. What goes to the terminal is left alone.

namespace {

constexpr std::size_t short_write = 3;

long failing_call = 0;  // none
bool later_ones_too = false, short_writes = false;
std::atomic<long> calls = 0;

__attribute__((constructor)) void begin() {
    const char* number = std::getenv("ASV_FAILING_FILE_CALL");
    if (number) failing_call = std::atol(number);
    later_ones_too = std::getenv("ASV_FAILING_FROM_THERE_ON") != nullptr;
    short_writes = std::getenv("ASV_SHORT_WRITES") != nullptr;
}

bool fails(int error) {
    if (failing_call == 0) return false;
    const long call = ++calls;
    if (call != failing_call && !(later_ones_too && call > failing_call)) return false;
    errno = error;
    return true;
}

/// The function of this name that would be called without this library.
template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// What open() and its like have as their last argument where the flags ask for it.
mode_t mode_in(int flags, va_list arguments) {
    const bool has_mode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    return has_mode ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_in(flags, arguments);
    va_end(arguments);
    return fails(EIO) ? -1 : next<int(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_in(flags, arguments);
    va_end(arguments);
    return fails(EIO) ? -1 : next<int(const char*, int, ...)>("open64")(path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    const bool to_a_file = descriptor > STDERR_FILENO;
    if (to_a_file && fails(ENOSPC)) return -1;
    if (short_writes && count > short_write) count = short_write;
    return next<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

int fsync(int descriptor) {
    return fails(EIO) ? -1 : next<int(int)>("fsync")(descriptor);
}

int rename(const char* from, const char* to) {
    return fails(EIO) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
    return fails(EIO) ? -1
                      : next<int(int, const char*, int, const char*, int)>("linkat")(
                            from_folder, from, to_folder, to, flags);
}
}
