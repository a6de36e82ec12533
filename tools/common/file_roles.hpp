#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/problem/problem_file.hpp"

namespace asv::tools {

/// A pipe or a device, to which writing may wait for a reader.
bool is_stream(const std::filesystem::path& file);

/// The files that one run of a program reads and writes, and what each is to it.
class FileRoles {
  public:
    /// role: what messages call it ("PROBLEM", "--stats"). An empty name stands for no file.
    void add_input(const std::string& role, const std::filesystem::path& file);
    void add_output(const std::string& role, const std::filesystem::path& file);

    /// The maps that a scenario has named.
    void add_maps(const io::ProblemFile& file);

    /// Throws UsageError, before anything is touched, when an output is the same file as an input
    /// or as another output: by its inode, whatever names and links lead to it, or by its place
    /// where it does not exist yet. Likewise when "-" stands for two inputs or two outputs. Devices
    /// (/dev/null) may have any number of roles; a file may be read twice.
    void require_distinct() const;

  private:
    struct Role {
        std::string name;
        std::filesystem::path file;
        bool output;
    };
    std::vector<Role> roles_;
};

}  // namespace asv::tools
