#pragma once

#include <string>

#include "core/model/body.hpp"
#include "core/solve/solve_result.hpp"
#include "io/batch/query_file.hpp"

/// Answers to queries, each one line of JSON, its end included (docs/programs.md).

namespace asv::io {

/// What became of a query for a body of that kind: the corners of its path are told as a query
/// tells its ends.
std::string answer_text(const Query& query, const core::SolveResult& result, core::BodyKind kind);

/// That a query cannot be answered, and why.
std::string refusal_text(const Query& query, const std::string& error);

}  // namespace asv::io
