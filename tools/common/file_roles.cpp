#include "tools/common/file_roles.hpp"

#include <map>
#include <optional>
#include <system_error>
#include <tuple>

#include <sys/stat.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {
namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;

/// What tells files apart: device and inode of the file; of one that does not exist yet those of
/// its folder, and its name in there.
using Identity = std::tuple<dev_t, ino_t, std::string>;

/// Where a name leads that does not exist yet: links that lead nowhere are followed.
fs::path end_of_links(fs::path file) {
    for (int i = 0; i < max_links; ++i) {
        std::error_code error;
        const fs::path target = fs::read_symlink(file, error);
        if (error) break;
        file = file.parent_path() / target;
    }
    return file;
}

/// None for what cannot be destroyed (a device) and for what cannot exist (no such folder).
std::optional<Identity> identity_of(const fs::path& file, bool output) {
    struct stat status {};
    const bool standard = file == io::standard_stream;
    const int found = standard ? ::fstat(output ? STDOUT_FILENO : STDIN_FILENO, &status)
                               : ::stat(file.c_str(), &status);
    if (found == 0) {
        if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return std::nullopt;
        return Identity{status.st_dev, status.st_ino, ""};
    }
    if (standard) return std::nullopt;
    const fs::path end = end_of_links(file);
    const fs::path folder = end.parent_path().empty() ? fs::path(".") : end.parent_path();
    if (::stat(folder.c_str(), &status) != 0) return std::nullopt;
    return Identity{status.st_dev, status.st_ino, end.filename().string()};
}

}  // namespace

bool is_stream(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return file == io::standard_stream || (!error && exists(status) && !is_regular_file(status));
}

void FileRoles::add_input(const std::string& role, const fs::path& file) {
    if (!file.empty()) roles_.push_back({role, file, false});
}

void FileRoles::add_output(const std::string& role, const fs::path& file) {
    if (!file.empty()) roles_.push_back({role, file, true});
}

void FileRoles::add_maps(const io::ProblemFile& file) {
    for (const fs::path& map : file.maps) add_input("the map of the scenario", map);
}

void FileRoles::require_distinct() const {
    const Role* standard[2] = {nullptr, nullptr};
    std::map<Identity, const Role*> known;
    for (const bool output : {false, true}) {
        for (const Role& role : roles_) {
            if (role.output != output) continue;
            if (role.file == io::standard_stream) {
                if (standard[output] != nullptr)
                    throw UsageError(standard[output]->name + " and " + role.name +
                                     " cannot both be - (standard " +
                                     (output ? "output)" : "input)"));
                standard[output] = &role;
            }
            const auto identity = identity_of(role.file, output);
            if (!identity) continue;
            const auto [other, is_new] = known.emplace(*identity, &role);
            if (is_new || !output) continue;
            throw UsageError(other->second->name + " (" + other->second->file.string() + ") and " +
                             role.name + " (" + role.file.string() +
                             ") are the same file; nothing was written");
        }
    }
}

}  // namespace asv::tools
