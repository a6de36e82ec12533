#include "io/text/temporary_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <random>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text/write_all.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;

constexpr mode_t all_that_the_mask_leaves = 0666;

/// Blocks all signals of this thread, so that the moment in which a hidden name exists is short.
class SignalsHeld {
  public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

  private:
    sigset_t before_{};
};

fs::path folder_of(const fs::path& target) {
    return target.parent_path().empty() ? fs::path(".") : target.parent_path();
}

/// A name beside the target that is unlikely to be taken; the system settles it.
fs::path hidden_name(const fs::path& target) {
    static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device random;
    std::string name = ".asv-";
    for (int i = 0; i < 12; ++i) name += letters[random() % letters.size()];
    return target.parent_path() / (name + ".tmp");
}

/// How the system calls a file that this process has open.
std::string open_file_name(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

/// Gives an open file a name; false, with errno set, when that fails.
bool link_open_file(const std::string& open_file, const fs::path& name) {
    return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// Puts an open file that has no name into the place of an old file. That takes two calls, and the
/// hidden name between them would stay where SIGKILL ends the process there.
class Replacement {
  public:
    Replacement(std::string open_file, fs::path target)
        : open_file_(std::move(open_file)),
          hidden_(hidden_name(target)),
          target_(std::move(target)) {}

    /// Both calls by a child that shares our memory, and goes on when we are killed. False, with
    /// errno set, when one fails.
    bool run() {
        constexpr int as_vfork = CLONE_VM | CLONE_VFORK | CLONE_FILES | CLONE_FS;
        std::array<std::byte, 64 * 1024> stack;
        const pid_t child = ::clone(run_in_child, stack.data() + stack.size(), as_vfork, this);
        if (child < 0) {
            link_and_rename();
        } else {
            // No other wait() of this process takes a child that sends no signal at its end.
            constexpr int such_a_child = static_cast<int>(__WCLONE);
            while (::waitpid(child, nullptr, such_a_child) < 0 && errno == EINTR) {
            }
        }
        errno = error_;
        return error_ == 0;
    }

  private:
    static int run_in_child(void* replacement) {
        static_cast<Replacement*>(replacement)->link_and_rename();
        return 0;
    }

    void link_and_rename() {
        if (!link_open_file(open_file_, hidden_)) {
            error_ = errno;
        } else if (::rename(hidden_.c_str(), target_.c_str()) != 0) {
            error_ = errno;
            ::unlink(hidden_.c_str());
        }
    }

    const std::string open_file_;
    const fs::path hidden_, target_;
    int error_ = 0;
};

/// A file that has no name yet, or a hidden one, and goes with this object unless it was published.
class HiddenFile {
  public:
    HiddenFile(const fs::path& target, Hiding hiding) : target_(target) {
        if (hiding == Hiding::nameless) {
            descriptor_ = ::open(folder_of(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                                 all_that_the_mask_leaves);
        } else {
            name_ = hidden_name(target);
            descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                                 all_that_the_mask_leaves);
            if (descriptor_ < 0) name_.clear();
        }
    }
    ~HiddenFile() {
        const int error = errno;
        close();
        if (!name_.empty()) ::unlink(name_.c_str());
        errno = error;
    }
    HiddenFile(const HiddenFile&) = delete;
    HiddenFile& operator=(const HiddenFile&) = delete;

    bool is_open() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }

    /// Gives it the name of the target; false, with errno set, when that fails.
    bool publish() {
        const SignalsHeld no_interruption;
        if (!name_.empty()) {
            if (!close() || ::rename(name_.c_str(), target_.c_str()) != 0) return false;
            name_.clear();
            return true;
        }
        // A new name can be had in one step.
        const std::string open_file = open_file_name(descriptor_);
        if (link_open_file(open_file, target_)) return close();
        return errno == EEXIST && Replacement(open_file, target_).run() && close();
    }

  private:
    /// The system may tell of a failed write only now, as NFS does.
    bool close() {
        const int descriptor = descriptor_;
        descriptor_ = -1;
        return descriptor < 0 || ::close(descriptor) == 0;
    }

    const fs::path& target_;
    fs::path name_;
    int descriptor_ = -1;
};

/// Best effort: some file systems know no owners, and only root may give files away.
void take_over(int descriptor, const Ownership& ownership) {
    struct stat now {};
    if (::fstat(descriptor, &now) != 0) return;
    if (now.st_uid != ownership.user || now.st_gid != ownership.group) {
        if (::fchown(descriptor, ownership.user, ownership.group) != 0)
            static_cast<void>(!::fchown(descriptor, static_cast<uid_t>(-1), ownership.group));
    }
    static_cast<void>(::fchmod(descriptor, ownership.permissions));
}

/// True also where the file system does not know how to.
bool flush_to_disk(int descriptor) {
    while (::fsync(descriptor) != 0) {
        if (errno == EINTR) continue;
        return errno == EINVAL || errno == ENOTSUP || errno == EROFS;
    }
    return true;
}

/// The name itself is on the disk only when the folder is.
void flush_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    static_cast<void>(flush_to_disk(descriptor));
    ::close(descriptor);
}

}  // namespace

bool put_in_place(const fs::path& target, std::string_view content,
                  const std::optional<Ownership>& ownership, Hiding hiding) {
    HiddenFile file(target, hiding);
    if (!file.is_open()) return false;
    if (ownership) take_over(file.descriptor(), *ownership);
    const bool written = [&] {
        const FileSizeSignalHeld held;
        return write_all(file.descriptor(), content);
    }();
    if (!written || !flush_to_disk(file.descriptor()) || !file.publish()) return false;
    flush_folder(folder_of(target));
    return true;
}

FileSizeSignalHeld::FileSizeSignalHeld() {
    sigset_t size_limit;
    sigemptyset(&size_limit);
    sigaddset(&size_limit, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &size_limit, &before_);
}

FileSizeSignalHeld::~FileSizeSignalHeld() {
    const int error = errno;
    // Taken from what waits for this thread; otherwise it would strike as soon as it may.
    if (sigismember(&before_, SIGXFSZ) == 0) {
        sigset_t size_limit;
        sigemptyset(&size_limit);
        sigaddset(&size_limit, SIGXFSZ);
        const timespec at_once{};
        while (sigtimedwait(&size_limit, nullptr, &at_once) > 0) {
        }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = error;
}

}  // namespace asv::io
