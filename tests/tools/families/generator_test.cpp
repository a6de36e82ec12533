#include "tools/families/generator.hpp"

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/problem/problem_digest.hpp"
#include "io/problem/problem_file.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// The words of asv-generate without the program.

namespace asv::tools {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
    std::istringstream stream(text);
    Words words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

test::Outcome asv_generate(const std::string& words, const std::filesystem::path& file) {
    // In front, so that a last word that lacks its value takes none of these for it.
    Words arguments{"--quiet", "-o", file.string()};
    for (const std::string& word : words_of(words)) arguments.push_back(word);
    return test::run_program("asv-generate", arguments);
}

TEST(Generated, IsWhatAsvGenerateWritesToTheLastBit) {
    const test::TemporaryFolder folder;
    for (const std::string words :
         {"corridor -n 7 --height-factor 1.1 --seed 3", "-n 5 bend --bends 3 --seed 12",
          "gauntlet --asvs 6 --walls 3", "rooms -n 009 --seed 010 --orientation cw",
          "maze -n 5 --way-factor 1.5", "spiral -n 4 --direction inward",
          "crossing -n 30 --start-arm east", "clutter -n 1 --obstacles 50",
          "bend -n 6 --infeasible fenced", "rooms -n 5 --infeasible turned --solvable",
          "corridor -n 10 --height-factor 1.01 --solvable --attempts 3 --seed 2"}) {
        SCOPED_TRACE(words);
        const auto file = folder / "p.txt";
        const test::Outcome written = asv_generate(words, file);
        ASSERT_EQ(written.exit_code, 0) << written.err;
        const GeneratedProblem made = generated(words_of(words));
        EXPECT_EQ(io::problem_digest(made.problem),
                  io::problem_digest(io::read_problem(file).problem));
        EXPECT_EQ(made.generation.asv_count, made.problem.asv_count());
    }
}

TEST(Generated, KnowsTheNumbersOfItsSideFile) {
    const test::TemporaryFolder folder;
    const std::string words = "gauntlet -n 5 --height-factor 1.5 --seed 4 --solvable";
    ASSERT_EQ(asv_generate(words, folder / "p.txt").exit_code, 0);
    EXPECT_EQ(io::number_parameters(generated(words_of(words)).generation.parameters),
              io::read_parameters(folder / "p.txt.json"));
}

TEST(Generated, WhatIsWrongIsToldInTheWordsOfTheProgram) {
    const test::TemporaryFolder folder;
    for (const std::string words :
         {"", "maz -n 5", "corridor", "corridor -n 2", "corridor -n 201", "corridor -n seven",
          "corridor -n 7 extra", "corridor -n 7 --walls 2", "corridor -n 7 --height nan",
          "corridor -n 7 --height 0.1 --height-factor 2", "corridor -n 7 --orientation up",
          "maze -n 7 --cells 40", "corridor -n", "clutter -n 1 --infeasible turned",
          "corridor -n 5 bend"}) {
        SCOPED_TRACE(words);
        const test::Outcome written = asv_generate(words, folder / "p.txt");
        EXPECT_EQ(written.exit_code, 2);
        try {
            generated(words_of(words));
            ADD_FAILURE() << "was accepted";
        } catch (const UsageError& error) {
            EXPECT_TRUE(test::contains(written.err, error.what()))
                << error.what() << "\nby the program: " << written.err;
        }
    }
}

TEST(Generated, KnowsNoFilesAndNoHelp) {
    for (const char* word : {"-o", "--output", "--quiet", "--help", "--version"})
        EXPECT_THROW(generated({"corridor", "-n", "5", word}), UsageError) << word;
}

}  // namespace
}  // namespace asv::tools
