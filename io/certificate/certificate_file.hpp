#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/certificate/certificate.hpp"

namespace asv::io {

/// A certificate is one JSON object:
///   {"version": 1,
///    "problem": {"asv_count", "obstacle_count", "broom_length", "max_step", "tolerance",
///    "digest"}, "reason": "no_area", "opposite_orientation", "separated" or "corridor_too_low",
///    "proof": {...}}
/// and the proof, by its reason,
///   {"chain_length", "greatest_area", "required_area"}
///   {"start_area", "goal_area", "greatest_change", "required_area"}
///   {"asv", "shrink", "obstacles": [1, ...],
///    "seams": [{"walls", "upright", "gap": [low x, low y, high x, high y], "width", "depth"},
///    ...]}
///   {"shrink", "required_area", "obstacles": [1, ...],
///    "corridors": [{"walls", "upright", "from", "to", "height", "greatest_area"}, ...]}
/// as core/certificate/certificate.hpp tells. ASVs and obstacles count from 1. "walls" are two
/// obstacles; null is the border.
inline constexpr int certificate_version = 1;

/// The file's text; numbers have the shortest digits that read back to the same number.
std::string format_certificate(const core::Certificate& certificate);

/// Writes it, whole or not at all. Throws WriteError.
void write_certificate(const std::filesystem::path& file, const core::Certificate& certificate);

/// Reads what write_certificate has written; "-" is standard input. Whether it says the truth is
/// another matter. Throws ParseError (not understood) or ReadError.
core::Certificate read_certificate(const std::filesystem::path& file);

/// The same from text; name stands for the file in messages.
core::Certificate parse_certificate(std::string_view text, const std::string& name);

}  // namespace asv::io
