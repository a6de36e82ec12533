#pragma once

#include <string>

#include <gtest/gtest.h>

#include "io/problem/scenario_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"

/// Small scenarios, and how a test changes and reads them.

namespace asv::io::scenario_samples {

inline const std::string point =
    R"({"version": 1, "body": {"kind": "point"}, "start": [0, 0], "goal": [1, 1]})";
inline const std::string arm = R"({"version": 1,
 "body": {"kind": "arm", "base": [1, 0], "links": [2, 1], "angles": "relative", "joints": "wrap"},
 "bounds": null, "start": [0, 1.5], "goal": [1, -7]})";

inline core::Problem read(const std::string& text) {
    return parse_scenario(text, "s.json", ".").problem;
}

/// The text with one part of it replaced.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

/// A text that is no scenario, and what is said of it.
struct Mistake {
    std::string text;
    std::string message;
};

inline std::string message(const std::string& text) {
    return test::error_message<ParseError>([&] { read(text); });
}

}  // namespace asv::io::scenario_samples
