#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/validation/validate.hpp"

namespace asv::io {

/// The checks of one path, of one state or of a trajectory, and where in its file the first state
/// stands.
struct ValidatedPart {
    std::string name;  ///< "path", "start", "goal" or "trajectory"
    /// None where not every state has a line of its own.
    std::optional<std::size_t> first_line = 2;
    core::ValidationReport report;

    /// The line of the file that the offender stands in, where it is known.
    std::optional<std::size_t> line(core::Check check, const core::Offender& offender) const {
        if (!first_line) return std::nullopt;
        return check == core::Check::cost ? 1 : *first_line + offender.state;
    }
};

/// All that a run of the validator found out.
struct ValidationSummary {
    std::string problem;
    std::string solution;  ///< empty when start and goal alone were checked
    double tolerance = 0;
    std::vector<ValidatedPart> parts;

    bool valid() const;
};

/// Writes one JSON object: problem, solution (or null), tolerance, valid, and for each part its
/// name, valid, checks and motion; each check with its name, ok, states, failures, worst (or null)
/// and offenders. ASVs, brooms and obstacles count from 1, states from 0. Whole or not at all.
/// Throws WriteError.
void write_validation(const std::filesystem::path& file, const ValidationSummary& summary);

}  // namespace asv::io
