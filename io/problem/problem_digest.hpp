#pragma once

#include <string>

#include "core/model/problem.hpp"

namespace asv::io {

/// 16 hexadecimal digits that stand for all numbers of the problem (FNV-1a over its text as a
/// scenario): files that read alike have one digest. Nothing for those who want to deceive.
std::string problem_digest(const core::Problem& problem);

}  // namespace asv::io
