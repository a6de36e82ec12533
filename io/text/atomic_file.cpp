#include "io/text/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text/parse_error.hpp"
#include "io/text/temporary_file.hpp"
#include "io/text/write_all.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;
constexpr std::size_t block = std::size_t{1} << 16U;
// A process that is told to end does so only when the read that it is in has returned.
constexpr std::size_t largest_read = std::size_t{1} << 20U;

[[noreturn]] void fail_to_read(const fs::path& file, int code) {
    throw ReadError(input_name(file) + ": " + std::generic_category().message(code));
}

[[noreturn]] void fail_to_write(const fs::path& file, int code) {
    throw WriteError(output_name(file) + ": " + std::generic_category().message(code));
}

bool is_standard_stream(const fs::path& file) {
    return file == standard_stream;
}

/// An open file that is closed on every way out.
class Descriptor {
  public:
    Descriptor(const fs::path& file, int flags) : number_(::open(file.c_str(), flags, 0666)) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }

    /// False with errno set when the system only now reports a failed write, as NFS does.
    bool close() {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0;
    }

  private:
    int number_;
};

/// Where the file really is, symbolic links followed; none when the name stands for an open file
/// of a process (/dev/stdout and the like), which cannot be replaced by a rename.
std::optional<fs::path> resolve_links(fs::path file) {
    for (int i = 0; i < max_links; ++i) {
        std::error_code error;
        const fs::path folder =
            fs::canonical(file.parent_path().empty() ? "." : file.parent_path(), error);
        if (!error && folder.native().starts_with("/proc/")) return std::nullopt;
        const fs::path target = fs::read_symlink(file, error);
        if (error) return file;
        file = file.parent_path() / target;
    }
    fail_to_write(file, ELOOP);
}

void write_directly(const fs::path& file, std::string_view content) {
    const FileSizeSignalHeld held;
    if (is_standard_stream(file)) {
        if (!write_all(STDOUT_FILENO, content)) fail_to_write(file, errno);
        return;
    }
    // Appending keeps what the shell has already redirected into the same file.
    Descriptor output(file, O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    if (!output.is_open() || !write_all(output.number(), content) || !output.close()) {
        fail_to_write(file, errno);
    }
}

/// Where the content of a file is to go.
struct Destination {
    fs::path target;     ///< with symbolic links followed
    bool direct = true;  ///< written as it is, not replaced
    std::optional<Ownership> old_ownership;
};

/// Throws WriteError when the file is a directory or a file that may not be written.
Destination locate(const fs::path& file) {
    if (is_standard_stream(file)) {
        if (::fcntl(STDOUT_FILENO, F_GETFD) < 0) fail_to_write(file, errno);
        return {file, true, std::nullopt};
    }
    struct stat status {};
    const bool exists = ::stat(file.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) fail_to_write(file, errno);
    if (exists && S_ISDIR(status.st_mode)) fail_to_write(file, EISDIR);
    if (!exists && !file.has_filename()) fail_to_write(file, ENOENT);
    // A rename would replace even a file that its owner has protected.
    if (exists && ::access(file.c_str(), W_OK) != 0) fail_to_write(file, errno);
    const std::optional<fs::path> target = resolve_links(file);
    if (!target || (exists && !S_ISREG(status.st_mode))) return {file, true, std::nullopt};
    if (!exists) return {*target, false, std::nullopt};
    return {*target, false, Ownership{status.st_uid, status.st_gid, status.st_mode & 0777U}};
}

std::string read_to_end(int descriptor, const fs::path& file, const struct stat& status,
                        std::size_t limit) {
    // One byte more than a regular file has, so that its end is seen without growing the buffer.
    const std::size_t known =
        S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
    std::string content(std::clamp(known, block, std::max(block, limit)) + 1, '\0');
    std::size_t size = 0;
    while (true) {
        if (size > limit) {
            throw ReadError(input_name(file) + ": File too large (at most " +
                            std::to_string(limit) + " bytes are read)");
        }
        if (size == content.size()) content.resize(std::min(2 * size, limit + 1));
        const ssize_t got = ::read(descriptor, content.data() + size,
                                   std::min(content.size() - size, largest_read));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_to_read(file, errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    content.resize(size);
    return content;
}

}  // namespace

std::string input_name(const fs::path& file) {
    return is_standard_stream(file) ? "<stdin>" : file.string();
}

std::string output_name(const fs::path& file) {
    return is_standard_stream(file) ? "<stdout>" : file.string();
}

std::string read_file(const fs::path& file, std::size_t limit) {
    struct stat status {};
    if (is_standard_stream(file)) {
        if (::fstat(STDIN_FILENO, &status) != 0) fail_to_read(file, errno);
        if (S_ISDIR(status.st_mode)) fail_to_read(file, EISDIR);
        return read_to_end(STDIN_FILENO, file, status, limit);
    }
    const Descriptor input(file, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (!input.is_open() || ::fstat(input.number(), &status) != 0) fail_to_read(file, errno);
    if (S_ISDIR(status.st_mode)) fail_to_read(file, EISDIR);
    return read_to_end(input.number(), file, status, limit);
}

std::string read_regular_file(const fs::path& file, std::size_t limit) {
    // Opening a pipe would wait for somebody to write into it.
    const Descriptor input(file, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    struct stat status {};
    if (!input.is_open() || ::fstat(input.number(), &status) != 0) fail_to_read(file, errno);
    if (!S_ISREG(status.st_mode)) throw ReadError(input_name(file) + ": not a regular file");
    return read_to_end(input.number(), file, status, limit);
}

void write_file(const fs::path& file, std::string_view content) {
    const Destination destination = locate(file);
    if (destination.direct) return write_directly(file, content);
    const auto put = [&](Hiding hiding) {
        return put_in_place(destination.target, content, destination.old_ownership, hiding);
    };
    if (!put(Hiding::nameless) && !put(Hiding::named)) fail_to_write(file, errno);
}

void require_writable(const fs::path& file) {
    const Destination destination = locate(file);
    if (destination.direct) return;
    const fs::path folder = destination.target.parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) {
        fail_to_write(file, errno);
    }
}

}  // namespace asv::io
