#pragma once

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"

namespace asv::test {

/// The result of that check.
inline const core::CheckResult& find(const std::vector<core::CheckResult>& results,
                                     core::Check check) {
    for (const core::CheckResult& result : results) {
        if (result.check == check) return result;
    }
    throw std::out_of_range("no such check");
}

/// The checks that failed, in the order of the report.
inline std::vector<core::Check> failed(const std::vector<core::CheckResult>& results) {
    std::vector<core::Check> checks;
    for (const core::CheckResult& result : results) {
        if (!result.ok()) checks.push_back(result.check);
    }
    return checks;
}

/// Asserts that every check holds, of the states and, where it was asked for, of the motions.
inline void expect_valid(const core::ValidationReport& report) {
    for (const auto* checks : {&report.checks, &report.motion})
        for (const core::CheckResult& check : *checks)
            ASSERT_TRUE(check.ok()) << name(check.check) << ": " << describe(check);
}

}  // namespace asv::test
