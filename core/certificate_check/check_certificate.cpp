#include "core/certificate_check/check_certificate.hpp"

#include <algorithm>
#include <sstream>

#include "core/certificate_check/claims.hpp"
#include "core/validation/validate.hpp"

namespace asv::core {

namespace certificate_check {

namespace {

void check_problem(const CertifiedProblem& stated, const Problem& problem,
                   const std::string& digest, Claims& claims) {
    const CertifiedProblem found = certified(problem, digest);
    const auto count = [&](const char* claim, std::size_t wanted, std::size_t is) {
        claims.add(claim, wanted == is,
                   wanted == is ? std::to_string(is)
                                : std::to_string(wanted) + " in the certificate, " +
                                      std::to_string(is) + " in the problem");
    };
    count("ASVs", stated.asv_count, found.asv_count);
    count("obstacles", stated.obstacle_count, found.obstacle_count);
    claims.add_number("broom length", stated.broom_length, exact(found.broom_length));
    claims.add_number("greatest step", stated.max_step, exact(found.max_step));
    claims.add_number("tolerance", stated.tolerance, exact(found.tolerance));
    const bool same = stated.digest == digest;
    claims.add("digest", same, same ? digest : "it is that of another problem");
}

/// Every proof but that of the area leads on from a valid start and goal.
void check_ends(const Problem& problem, Claims& claims) {
    ValidationOptions options;
    options.tolerance = problem.requirements.tolerance;
    const bool start = validate_state(problem, problem.start, options).valid();
    const bool goal = validate_state(problem, problem.goal, options).valid();
    claims.add("start and goal", start && goal,
               start && goal ? "valid" : std::string(start ? "goal" : "start") + " is not valid");
}

}  // namespace

bool all_hold(const std::vector<CheckedClaim>& claims) {
    return std::all_of(claims.begin(), claims.end(),
                       [](const CheckedClaim& claim) { return claim.holds; });
}

void Claims::add_number(const std::string& claim, double stated, const Number& found) {
    const bool same = agrees(stated, found);
    const std::string text = text_of(found);
    add(claim, same, same ? text : text_of(exact(stated)) + " is stated, " + text + " is found");
}

std::string text_of(const Number& value) {
    std::ostringstream text;
    text.precision(8);
    text << rounded(value);
    return text.str();
}

}  // namespace certificate_check

bool CertificateVerdict::accepted() const {
    return certificate_check::all_hold(claims);
}

CertificateVerdict check_certificate(const Certificate& certificate, const Problem& problem,
                                     const std::string& digest) {
    using namespace certificate_check;
    Claims claims;
    check_problem(certificate.problem, problem, digest, claims);
    // What it says of another problem is beside the point.
    if (!claims.hold()) return {claims.take()};
    if (!std::holds_alternative<AreaProof>(certificate.proof)) check_ends(problem, claims);
    std::visit([&](const auto& proof) { check(proof, problem, claims); }, certificate.proof);
    return {claims.take()};
}

}  // namespace asv::core
