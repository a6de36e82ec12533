#include "tools/families/likeness.hpp"

#include <algorithm>
#include <numeric>

namespace asv::tools {

namespace {

std::size_t letters_apart(const std::string& a, const std::string& b) {
    // Of what was read of a, to each beginning of b.
    std::vector<std::size_t> apart(b.size() + 1);
    std::iota(apart.begin(), apart.end(), std::size_t{0});
    for (const char letter : a) {
        std::size_t changed = apart[0]++;
        for (std::size_t i = 0; i < b.size(); ++i) {
            const std::size_t kept = changed + (letter == b[i] ? 0 : 1);
            changed = apart[i + 1];
            apart[i + 1] = std::min({kept, apart[i] + 1, apart[i + 1] + 1});
        }
    }
    return apart.back();
}

}  // namespace

std::string listed_by_likeness(std::vector<std::string> words, const std::string& given) {
    if (!given.empty())
        std::stable_sort(words.begin(), words.end(), [&](const auto& a, const auto& b) {
            return letters_apart(given, a) < letters_apart(given, b);
        });
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

}  // namespace asv::tools
