#include "tests/kit/chains/random_chains.hpp"

#include <cmath>
#include <numbers>

namespace asv::test {

Points random_chain(Random& random, std::size_t n) {
    std::vector<double> turns(n - 2);
    double sum = 0;
    for (double& turn : turns) {
        turn = random.one_in(5) ? 0 : -std::log(random.uniform(0.01, 1));
        sum += turn;
    }
    const double total = random.uniform(0.5, 1.9 * std::numbers::pi);
    const double sign = random.one_in(2) ? 1 : -1;
    for (double& turn : turns) turn *= sum > 0 ? sign * total / sum : 0;
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    return chain_with_turns({x, y}, random.uniform(-4, 4), turns);
}

void shake(Random& random, Points& chain, double size) {
    for (Point& point : chain) {
        point.x += random.uniform(-size, size);
        point.y += random.uniform(-size, size);
    }
}

}  // namespace asv::test
