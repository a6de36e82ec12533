#pragma once

#include <cstddef>
#include <string>

namespace asv::tools {

/// One line on standard error that is drawn again and again while long work runs; nothing where
/// standard error is no terminal.
class ProgressLine {
  public:
    explicit ProgressLine(bool wanted);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    bool visible() const { return visible_; }
    void show(const std::string& text);
    /// Takes the line away, so that messages start on an empty one.
    void clear();

  private:
    bool visible_;
    std::size_t drawn_ = 0;
};

}  // namespace asv::tools
