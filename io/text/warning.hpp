#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asv::io {

/// Something that was understood but is not as the format says. Line and column count from 1,
/// columns in bytes.
struct Warning {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
    std::string message;
};

/// "FILE:LINE:COLUMN: warning: MESSAGE", fit for a terminal whatever the file holds.
std::string to_text(const Warning& warning);

/// Collects warnings while a file is read, the first hundred of them; the last one then tells how
/// many more there were.
class WarningList {
  public:
    void add(Warning warning);
    /// Will the next one only be counted?
    bool is_full() const;
    /// What was collected; the list is empty afterwards.
    std::vector<Warning> take();

  private:
    std::vector<Warning> warnings_;
    std::size_t unlisted_ = 0;
};

}  // namespace asv::io
