#include "core/solve/solve_result.hpp"

namespace asv::core {

std::string_view name(SolveStatus status) {
    switch (status) {
        case SolveStatus::solved:
            return "solved";
        case SolveStatus::timeout:
            return "timeout";
        case SolveStatus::infeasible:
            return "infeasible";
        case SolveStatus::interrupted:
            return "interrupted";
    }
    return "unknown";
}

std::string_view name(TreeRoot root) {
    switch (root) {
        case TreeRoot::start:
            return "start";
        case TreeRoot::goal:
            return "goal";
        case TreeRoot::roadmap:
            return "roadmap";
    }
    return "unknown";
}

}  // namespace asv::core
