#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace asv::tools {

/// A name for each of many files: "frame-%d.png" stands for frame-0.png, frame-1.png and so on,
/// "%04d" for numbers with zeros in front.
class NumberedName {
  public:
    /// None where no such place stands in the file's name.
    static std::optional<NumberedName> of(const std::filesystem::path& pattern);

    std::filesystem::path at(std::size_t number) const;

  private:
    std::string before_, after_;
    std::size_t digits_ = 0;
};

}  // namespace asv::tools
