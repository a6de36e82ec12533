#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string_view>

#include <sys/types.h>

namespace asv::io {

/// Whose a file is, and who may do what with it.
struct Ownership {
    uid_t user;
    gid_t group;
    mode_t permissions;
};

/// How a file gets to its name when it is whole.
enum class Hiding {
    nameless,  ///< it has no name until then: nothing is left behind, however the process ends
    named,     ///< a name beside the target, for file systems that know no nameless files
};

/// Writes a new file with this content and gives it the name of the target, which is replaced as a
/// whole; content and name are on the disk when this returns, as far as the file system tells. An
/// owner and permissions are taken over where the process may. False, with errno set and nothing
/// left behind, when any of it fails. Precondition: the target is no symbolic link.
bool put_in_place(const std::filesystem::path& target, std::string_view content,
                  const std::optional<Ownership>& ownership, Hiding hiding);

/// While it lives, a write beyond the size that files may have (ulimit -f) fails with EFBIG in this
/// thread instead of ending the process by SIGXFSZ.
class FileSizeSignalHeld {
  public:
    FileSizeSignalHeld();
    ~FileSizeSignalHeld();
    FileSizeSignalHeld(const FileSizeSignalHeld&) = delete;
    FileSizeSignalHeld& operator=(const FileSizeSignalHeld&) = delete;

  private:
    sigset_t before_{};
};

}  // namespace asv::io
