#include "io/text/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text/parse_error.hpp"
#include "io/text/write_all.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;
constexpr std::size_t block = std::size_t{1} << 16U;

template <typename Error>
[[noreturn]] void fail(const fs::path& file, int code) {
    throw Error(file.string() + ": " + std::generic_category().message(code));
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

/// Removes the file on every way out unless it was kept.
class TemporaryName {
  public:
    explicit TemporaryName(fs::path path) : path_(std::move(path)) {}
    ~TemporaryName() {
        if (!kept_) ::unlink(path_.c_str());
    }
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    void keep() { kept_ = true; }

  private:
    fs::path path_;
    bool kept_ = false;
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
    fail<WriteError>(file, ELOOP);
}

void write_directly(const fs::path& file, std::string_view content) {
    // Appending keeps what the shell has already redirected into the same file.
    Descriptor output(file, O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    if (!output.is_open() || !write_all(output.number(), content) || !output.close()) {
        fail<WriteError>(file, errno);
    }
}

/// A name beside the target that is unlikely to be taken; open() with O_EXCL settles it.
fs::path temporary_beside(const fs::path& target) {
    static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device random;
    std::string name = ".asv-";
    for (int i = 0; i < 12; ++i) name += letters[random() % letters.size()];
    return target.parent_path() / (name + ".tmp");
}

/// Where the content of a file is to go.
struct Destination {
    fs::path target;     ///< with symbolic links followed
    bool direct = true;  ///< written as it is, not replaced
    std::optional<mode_t> old_permissions;
};

/// Throws WriteError when the file is a directory or a file that may not be written.
Destination locate(const fs::path& file) {
    struct stat status {};
    const bool exists = ::stat(file.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) fail<WriteError>(file, errno);
    if (exists && S_ISDIR(status.st_mode)) fail<WriteError>(file, EISDIR);
    if (!exists && !file.has_filename()) fail<WriteError>(file, ENOENT);
    // A rename would replace even a file that its owner has protected.
    if (exists && ::access(file.c_str(), W_OK) != 0) fail<WriteError>(file, errno);
    const std::optional<fs::path> target = resolve_links(file);
    if (!target || (exists && !S_ISREG(status.st_mode))) return {file, true, std::nullopt};
    if (!exists) return {*target, false, std::nullopt};
    return {*target, false, status.st_mode & 0777U};
}

/// shown is the name that the user gave.
void replace(const fs::path& shown, const Destination& destination, std::string_view content) {
    const fs::path temporary = temporary_beside(destination.target);
    Descriptor output(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    if (!output.is_open()) fail<WriteError>(shown, errno);
    TemporaryName guard(temporary);
    // Best effort: some file systems know no permissions.
    if (destination.old_permissions) {
        static_cast<void>(::fchmod(output.number(), *destination.old_permissions));
    }
    if (!write_all(output.number(), content) || !output.close() ||
        ::rename(temporary.c_str(), destination.target.c_str()) != 0) {
        fail<WriteError>(shown, errno);
    }
    guard.keep();
}

}  // namespace

std::string read_file(const fs::path& file, std::size_t limit) {
    const Descriptor input(file, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    struct stat status {};
    if (!input.is_open() || ::fstat(input.number(), &status) != 0) fail<ReadError>(file, errno);
    if (S_ISDIR(status.st_mode)) fail<ReadError>(file, EISDIR);
    // One byte more than a regular file has, so that its end is seen without growing the buffer.
    const std::size_t known =
        S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
    std::string content(std::clamp(known, block, std::max(block, limit)) + 1, '\0');
    std::size_t size = 0;
    while (true) {
        if (size > limit) fail<ReadError>(file, EFBIG);
        if (size == content.size()) content.resize(std::min(2 * size, limit + 1));
        const ssize_t got = ::read(input.number(), content.data() + size, content.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail<ReadError>(file, errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
    }
    content.resize(size);
    return content;
}

void write_file(const fs::path& file, std::string_view content) {
    const Destination destination = locate(file);
    if (destination.direct) {
        write_directly(file, content);
    } else {
        replace(file, destination, content);
    }
}

void require_writable(const fs::path& file) {
    const Destination destination = locate(file);
    if (destination.direct) return;
    const fs::path folder = destination.target.parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) {
        fail<WriteError>(file, errno);
    }
}

}  // namespace asv::io
