#include "io/benchmark/record/command_words.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace asv::io {
namespace {

using Words = std::vector<std::string>;

TEST(SplitCommand, PartsAtBlanksOutsideOfQuotes) {
    EXPECT_EQ(split_command("./p  {problem}\t-o {solution} "),
              (Words{"./p", "{problem}", "-o", "{solution}"}));
    EXPECT_EQ(split_command("'my planner' --name=\"it's\" a'b c'd \"\""),
              (Words{"my planner", "--name=it's", "ab cd", ""}));
    EXPECT_EQ(split_command("a\\ b $HOME *.txt; c|d"),
              (Words{"a\\", "b", "$HOME", "*.txt;", "c|d"}));
    EXPECT_EQ(split_command("  "), Words{});
    EXPECT_THROW(split_command("a 'b"), std::invalid_argument);
}

TEST(JoinCommand, IsSplitIntoTheSameWords) {
    const Words words{"plain", "", "two words", "it's", "say \"no\"", "both ' and \"", "a=b"};
    EXPECT_EQ(split_command(join_command(words)), words);
    EXPECT_EQ(join_command({"./p", "{problem}"}), "./p {problem}");
}

TEST(FillIn, PutsValuesInThePlaceOfNames) {
    const CommandValues values{"a b.txt", "s.txt", "7", "0.5"};
    EXPECT_EQ(fill_in("--in={problem}", values), "--in=a b.txt");
    EXPECT_EQ(fill_in("{solution}{seed}{time}", values), "s.txt70.5");
    EXPECT_EQ(fill_in("{{{seed}}}", values), "{7}");
    for (const char* wrong : {"{speed}", "{", "}", "{seed", "seed}"})
        EXPECT_THROW(fill_in(wrong, values), std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace asv::io
