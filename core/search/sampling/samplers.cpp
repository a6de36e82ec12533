#include "core/search/sampling/samplers.hpp"

#include <cmath>
#include <numbers>

namespace asv::core {

std::vector<std::size_t> grid_divisions(std::span<const double> extents, std::size_t count) {
    std::vector<std::size_t> divisions(extents.size(), 1);
    std::size_t cells = 1;
    while (true) {
        std::size_t longest = 0;
        const auto length = [&](std::size_t i) {
            return extents[i] / static_cast<double>(divisions[i]);
        };
        for (std::size_t i = 1; i < extents.size(); ++i)
            if (length(i) > length(longest)) longest = i;
        const std::size_t more = cells / divisions[longest] * (divisions[longest] + 1);
        if (more > count) return divisions;
        ++divisions[longest];
        cells = more;
    }
}

void grid_point(std::span<const std::size_t> divisions, std::size_t k, std::span<double> unit) {
    for (std::size_t i = 0; i < divisions.size(); ++i) {
        // Multiples of the golden ratio spread evenly, and no two of them are alike.
        const double aside = static_cast<double>(i + 1) * std::numbers::phi;
        const double place = 0.4 + 0.2 * (aside - std::floor(aside));
        unit[i] =
            (static_cast<double>(k % divisions[i]) + place) / static_cast<double>(divisions[i]);
        k /= divisions[i];
    }
}

}  // namespace asv::core
