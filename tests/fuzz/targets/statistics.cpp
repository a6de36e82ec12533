#include <cmath>

#include "io/solution/run_facts.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

void statistics(std::string_view input) {
    try {
        const io::RunFacts facts = io::parse_run_facts(input, "input");
        require(!facts.lower_bound || (*facts.lower_bound > 0 && std::isfinite(*facts.lower_bound)),
                "a lower bound is a positive number");
    } catch (const io::ParseError& error) {
        require_place_in(input, error);
    }
}

}  // namespace asv::fuzz
