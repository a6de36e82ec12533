#pragma once

#include <filesystem>
#include <string>

#include "core/certificate_check/check_certificate.hpp"

namespace asv::io {

/// Writes one JSON object: problem and certificate, as their files were given, accepted, and
/// claims, each with claim, ok and detail. Whole or not at all. Throws WriteError.
void write_verdict(const std::filesystem::path& file, const std::string& problem,
                   const std::string& certificate, const core::CertificateVerdict& verdict);

}  // namespace asv::io
