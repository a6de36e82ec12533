#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"
#include "geometry/simd/instruction_set.hpp"
#include "io/solution/solution_file.hpp"
#include "tests/core/solve/end_to_end/other_libm.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"

/// What solve() finds is the same on every machine: with each compiler, optimisation, instruction
/// set and C library. same_bytes.txt has a hash for each problem, planner and seed, of the file
/// that asv-solve writes with one thread and of all nodes of its trees. It changes only when paths
/// are meant to change.

namespace asv::core {
namespace {

namespace simd = geometry::simd;

constexpr const char* golden_file = ASV_SOURCE_DIR "/tests/core/solve/end_to_end/same_bytes.txt";

struct Case {
    std::string problem;  ///< file of testcases/
    std::string planner;
    std::uint64_t seed = 1;
    std::string hash = {};

    std::string name() const { return problem + " " + planner + " " + std::to_string(seed); }
};

std::vector<Case> golden_cases() {
    std::vector<Case> cases;
    std::ifstream in(golden_file);
    for (Case one; in >> one.problem >> one.planner >> one.seed >> one.hash;) cases.push_back(one);
    return cases;
}

/// FNV-1a (Fowler, Noll, Vo 1991), which every machine computes alike.
class Hash {
  public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * prime;
    }
    /// The bits of a number, of zeros only one.
    void add(double number) {
        number += 0.0;
        add({reinterpret_cast<const char*>(&number), sizeof number});
    }
    std::string text() const {
        std::ostringstream out;
        out << std::hex << std::setw(16) << std::setfill('0') << value_;
        return out.str();
    }

  private:
    static constexpr std::uint64_t prime = 0x100000001b3;
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Few iterations, since a tree that is not complete tells of a difference as well.
SolveOptions options_of(const Case& one) {
    SolveOptions options;
    options.planner = planner_named(one.planner);
    options.seed = one.seed;
    options.time_limit = 600;
    options.max_iterations = 300;
    options.optimize = 0.01;
    options.keep_trees = true;
    options.find_bounds = false;
    return options;
}

std::string hash_of(const Case& one) {
    const SolveResult result = solve(test::testcase(one.problem), options_of(one));
    Hash hash;
    if (result.solution) hash.add(io::format_solution(*result.solution));
    for (const TreePicture& tree : result.trees)
        for (const Point& point : tree.points) {
            hash.add(point.x);
            hash.add(point.y);
        }
    return hash.text();
}

/// Every so many of the list, where a build is slow.
std::vector<Case> some_of(const std::vector<Case>& all) {
    const std::size_t count = std::min(all.size(), test::scaled(all.size()));
    std::vector<Case> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[i * all.size() / count]);
    return chosen;
}

struct SameBytes : testing::Test {
    ~SameBytes() override { simd::use_best_instruction_set(); }
};

TEST_F(SameBytes, OnEveryMachine) {
    const std::vector<Case> cases = some_of(golden_cases());
    ASSERT_FALSE(cases.empty());
    for (const std::string& set : simd::instruction_sets()) {
        simd::use_instruction_set(set);
        for (const Case& one : cases)
            EXPECT_EQ(hash_of(one), one.hash) << one.name() << " on " << set;
    }
}

TEST_F(SameBytes, WithEveryLibm) {
    const test::OtherLibm other_libm;
    volatile double two = 2;  // not known to the compiler
    ASSERT_GT(std::log(two), std::numbers::ln2) << "the C library's functions are called";
    for (const Case& one : some_of(golden_cases())) EXPECT_EQ(hash_of(one), one.hash) << one.name();
}

/// Not a test: writes the list anew, where paths are meant to change.
TEST_F(SameBytes, DISABLED_WriteTheList) {
    const auto cases = golden_cases();
    std::ofstream out(golden_file);
    for (const Case& one : cases) out << one.name() << ' ' << hash_of(one) << '\n';
}

}  // namespace
}  // namespace asv::core
