#include <algorithm>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"
#include "tests/fuzz/targets/targets.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

/// The seeds of the fuzzers, and all inputs that they have found, in every build.

namespace asv::fuzz {

/// So that a failure names the kind of input. GoogleTest looks for it where the type is.
static void PrintTo(const Target& target, std::ostream* out) {
    *out << target.name;
}

namespace {

namespace fs = std::filesystem;

struct Corpus : testing::TestWithParam<Target> {};

INSTANTIATE_TEST_SUITE_P(Every, Corpus, testing::ValuesIn(targets),
                         [](const auto& target) { return std::string(target.param.name); });

TEST_P(Corpus, EveryInputIsRefusedOrKeepsItsPromises) {
    std::vector<fs::path> files;
    const fs::path folder = fs::path(ASV_SOURCE_DIR "/tests/fuzz/corpus") / GetParam().name;
    std::copy(fs::directory_iterator(folder), fs::directory_iterator(), std::back_inserter(files));
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) EXPECT_NO_THROW(GetParam().run(io::read_file(file))) << file;
}

TEST(SmallCases, RandomOnesAreRefusedOrSolvedAsPromised) {
    constexpr std::size_t longest = 80;
    for (std::uint64_t seed = 1; seed <= test::scaled(200); ++seed) {
        test::Random random(seed);
        std::string bytes(random.below(longest), '\0');
        std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random.bits()); });
        EXPECT_NO_THROW(solve(bytes)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace asv::fuzz
