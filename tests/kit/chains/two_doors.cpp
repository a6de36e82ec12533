#include "tests/kit/chains/two_doors.hpp"

#include "tests/kit/chains/problems.hpp"

namespace asv::test {

core::Problem two_doors() {
    return problem({{0.2, 0.4}, {0.24, 0.37}, {0.28, 0.4}}, {{0.8, 0.4}, {0.84, 0.37}, {0.88, 0.4}},
                   {{{0.5, 0}, {0.6, near_door.low.y}},
                    {{0.5, near_door.high.y}, {0.6, far_door.low.y}},
                    {{0.5, far_door.high.y}, {0.6, 1}}});
}

}  // namespace asv::test
