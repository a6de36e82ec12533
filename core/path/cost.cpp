#include "asv/core/path/cost.hpp"

#include <cmath>

namespace asv::core {

double cost(const Path& path) {
    // Kahan's summation (1965).
    double sum = 0, lost = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto from = path.state(i - 1), to = path.state(i);
        for (std::size_t j = 0; j < path.asv_count(); ++j) {
            const double term = std::hypot(to[j].x - from[j].x, to[j].y - from[j].y) - lost;
            const double next = sum + term;
            lost = (next - sum) - term;
            sum = next;
        }
    }
    return sum;
}

}  // namespace asv::core
