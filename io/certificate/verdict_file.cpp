#include "io/certificate/verdict_file.hpp"

#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"

namespace asv::io {

void write_verdict(const std::filesystem::path& file, const std::string& problem,
                   const std::string& certificate, const core::CertificateVerdict& verdict) {
    using nlohmann::ordered_json;
    ordered_json claims = ordered_json::array();
    for (const core::CheckedClaim& claim : verdict.claims)
        claims.push_back({{"claim", claim.claim}, {"ok", claim.holds}, {"detail", claim.detail}});
    const ordered_json root = {{"problem", problem},
                               {"certificate", certificate},
                               {"accepted", verdict.accepted()},
                               {"claims", std::move(claims)}};
    // File names need not be UTF-8, as JSON is.
    write_file(file, root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace asv::io
