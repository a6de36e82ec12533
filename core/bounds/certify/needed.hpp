#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace asv::core {

/// What is left of the things when as many as possible are dropped, one after the other and first
/// in large parts, without `suffices` becoming false for the rest. `effort` things may be looked
/// at in all; then no more are dropped. Precondition: suffices(things).
template <typename Thing, typename Suffices>
std::vector<Thing> needed(std::vector<Thing> things, const Suffices& suffices, std::size_t effort) {
    for (std::size_t part = std::max<std::size_t>(1, things.size() / 2); part > 0; part /= 2) {
        for (std::size_t begin = 0; begin < things.size();) {
            if (effort < things.size()) return things;
            effort -= things.size();
            const auto from = things.begin() + static_cast<std::ptrdiff_t>(begin);
            const std::size_t end = std::min(begin + part, things.size());
            std::vector<Thing> rest(things.begin(), from);
            rest.insert(rest.end(), things.begin() + static_cast<std::ptrdiff_t>(end),
                        things.end());
            if (suffices(rest))
                things = std::move(rest);
            else
                begin = end;
        }
    }
    return things;
}

}  // namespace asv::core
