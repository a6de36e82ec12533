#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tests/kit/random.hpp"

namespace asv::test {

/// The text with one to five places broken as a bad disk, an editor or an enemy would.
inline std::string mutated(std::string text, Random& random) {
    static constexpr std::array<std::string_view, 14> words = {
        "nan", "-inf",   "1e999",      "-1", "18446744073709551615", "0x1f", "\n\n",
        " ",   "1e-999", "1000000000", "\r", "\xEF\xBB\xBF",         ",",    "0"};
    for (std::size_t i = 1 + random.below(5); i > 0 && !text.empty(); --i) {
        const std::size_t place = random.below(text.size());
        const std::size_t length = 1 + random.below(20);
        switch (random.below(6)) {
            case 0:
                text[place] = static_cast<char>(random.bits());
                break;
            case 1:
                text.erase(place, length);
                break;
            case 2:
                text.insert(place, text.substr(random.below(text.size()), length));
                break;
            case 3:
                text.insert(place, words[random.below(words.size())]);
                break;
            case 4:
                text.resize(place);
                break;
            default:
                text.insert(place, 1, static_cast<char>(random.bits()));
                break;
        }
    }
    return text;
}

}  // namespace asv::test
