#include "io/text/warning.hpp"

#include <utility>

#include "io/text/escape.hpp"

namespace asv::io {
namespace {

constexpr std::size_t max_listed = 100;

}  // namespace

std::string to_text(const Warning& warning) {
    return escaped(warning.file + ":" + std::to_string(warning.line) + ":" +
                   std::to_string(warning.column) + ": warning: " + warning.message);
}

bool WarningList::is_full() const {
    return warnings_.size() >= max_listed;
}

void WarningList::add(Warning warning) {
    if (!is_full()) {
        warnings_.push_back(std::move(warning));
    } else {
        ++unlisted_;
    }
}

std::vector<Warning> WarningList::take() {
    if (unlisted_ > 0) {
        warnings_.back().message +=
            " (" + std::to_string(unlisted_) + " further warnings are not listed)";
        unlisted_ = 0;
    }
    return std::exchange(warnings_, {});
}

}  // namespace asv::io
