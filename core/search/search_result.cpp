#include "core/search/search_result.hpp"

namespace asv::core {

std::string_view name(Outcome outcome) {
    switch (outcome) {
        case Outcome::solved:
            return "solved";
        case Outcome::iterations:
            return "iteration limit";
        case Outcome::nodes:
            return "node limit";
        case Outcome::deadline:
            return "time limit";
        case Outcome::stopped:
            return "stopped";
    }
    return "unknown";
}

}  // namespace asv::core
