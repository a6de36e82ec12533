#pragma once

#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

/// A page has no files but those that come with a request. As long as this lives they are what io
/// reads, found by the last part of their names.
class GivenFiles {
  public:
    /// Each member of the object is a file, its bytes as characters U+0000 to U+00FF.
    explicit GivenFiles(const Json& files);
    ~GivenFiles();
    GivenFiles(const GivenFiles&) = delete;
    GivenFiles& operator=(const GivenFiles&) = delete;
};

}  // namespace asv::playground
