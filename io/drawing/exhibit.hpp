#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bounds/feasibility.hpp"
#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/validate.hpp"
#include "io/drawing/path_profile.hpp"
#include "io/solution/trees_file.hpp"

namespace asv::io {

/// One state that violates one requirement, as the validator has it.
struct Violation {
    core::Check check = core::Check::ends;
    core::Offender offender;
};

/// What there is to see of one problem, as it was given.
struct ExhibitInput {
    std::string name;  ///< shown as the title; the problem's file name without its ending
    core::Problem problem;
    std::optional<core::Solution> solution = {};
    std::optional<SearchTrees> trees = {};
    std::optional<double> lower_bound = {};  ///< of the cost
    std::string planner = {};                ///< shown when not empty
    std::string unit = {};                   ///< of lengths, shown behind them when not empty
};

/// The same with everything measured and judged that a picture or a player tells.
struct Exhibit : ExhibitInput {
    core::ValidationReport report;  ///< of the solution; without one, of start and goal
    /// Without a solution, of up to 20,000 obstacles and valid ends: why there is no path, if
    /// known.
    core::Feasibility feasibility;
    std::vector<StateMeasures> measures;        ///< for each state of the solution
    std::vector<Violation> violations;          ///< of the solution, by state
    std::optional<std::size_t> tightest_state;  ///< where the clearance is least, the first such
};

/// Measures and validates. Precondition: a solution has as many ASVs as the problem, and a state.
Exhibit make_exhibit(ExhibitInput input);

/// "7 ASVs · 7 obstacles · cost 13.2214 · at least 12.0402 (ratio 1.098) · 3,059 steps". Costs have
/// the unit behind them, but for an arm's, which are angles.
std::string facts(const Exhibit& exhibit);

/// "valid", "not valid: 2 of 8 requirements violated", "start and goal are valid", or "there is no
/// path".
std::string verdict(const Exhibit& exhibit);

/// One sentence for each failed check, with the step where it has one; or why there is no path.
std::vector<std::string> complaints(const Exhibit& exhibit);

/// What a legend calls the parts of a body.
struct BodyWords {
    std::string first;      ///< the point that has an eye
    std::string chain;      ///< the whole body
    std::string path;       ///< the way of one of its points
    std::string link;       ///< what can collide, empty for a point
    std::string seen;       ///< the point whose places a tree shows
    std::string seen_path;  ///< its way
    std::string counted;    ///< what its points are counted as, empty for a point
};
BodyWords words_for(core::BodyKind body);

/// 12345678 as "12,345,678".
std::string grouped(std::size_t number);

/// A length and its unit behind it; the length alone where there is no unit.
std::string with_unit(std::string length, const std::string& unit);

/// A number with so many digits behind the point.
std::string fixed(double number, int digits);

}  // namespace asv::io
