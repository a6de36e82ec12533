#include "io/certificate/certificate_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/certificate/verdict_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using core::Certificate;

const core::CertifiedProblem about{7, 3, 0.05, 0.001, 1e-5, "0123456789abcdef"};

const core::SeparationProof separation{
    3, 0.000515, {0, 2}, {{{{0, std::nullopt}, true}, {{0.1, 0.2}, {0.3, 0.4}}, 2e-5, 0.1}}};

const core::CorridorProof corridors{
    0.000515, 0.0055, {0, 1}, {{{{0, 1}, false}, 0.25, 0.5, 0.02, 0.005}}};

TEST(CertificateFile, SaysWhatItsPageSays) {
    EXPECT_EQ(format_certificate({about, separation}),
              R"({"version": 1,
 "problem": {"asv_count":7,"obstacle_count":3,"broom_length":0.05,"max_step":0.001,"tolerance":1e-05,"digest":"0123456789abcdef"},
 "reason": "separated",
 "proof": {"asv":4,"shrink":0.000515,"obstacles":[1,3],"seams":[{"walls":[1,null],"upright":true,"gap":[0.1,0.2,0.3,0.4],"width":2e-05,"depth":0.1}]}}
)");
}

TEST(CertificateFile, IsReadAsItWasWritten) {
    const test::TemporaryFolder folder;
    for (const core::InfeasibilityProof& proof : std::vector<core::InfeasibilityProof>{
             core::AreaProof{0.3, 0.01, 0.02}, core::OrientationProof{0.1, -0.1, 0.01, 0.02},
             separation, corridors}) {
        const std::string text = format_certificate({about, proof});
        write_certificate(folder / "c", {about, proof});
        EXPECT_EQ(read_file(folder / "c"), text);
        EXPECT_EQ(format_certificate(read_certificate(folder / "c")), text);
    }
}

/// The text with a part of it exchanged.
std::string with(const std::string& part, const std::string& other,
                 const core::InfeasibilityProof& proof = separation) {
    std::string text = format_certificate({about, proof});
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

TEST(CertificateFile, TellsThePlaceOfWhatIsNotUnderstood) {
    const auto message = [](const std::string& text) {
        return test::error_message<ParseError>([&] { parse_certificate(text, "c.json"); });
    };
    EXPECT_EQ(message(with("\"version\": 1", "\"version\": 2")),
              "c.json:1:13: expected the integer 1 at version, found 2");
    EXPECT_EQ(message(with("separated", "magic")),
              "c.json:3:12: expected no_area, opposite_orientation, separated or corridor_too_low "
              "at reason, found \"magic\"");
    EXPECT_EQ(message(with("\"asv\":4", "\"asv\":0")),
              "c.json:4:18: expected an integer from 1 to 1000000000 at proof.asv, found 0");
    EXPECT_EQ(message(with("[1,null]", "[1]")),
              "c.json:4:74: expected an array of two walls: obstacles, or null for the border at "
              "proof.seams[0].walls, found [1]");
    EXPECT_EQ(message(with("[0.1,0.2,0.3,0.4]", "[0.1]")),
              "c.json:4:104: expected an array of the four numbers low x, low y, high x, high y at "
              "proof.seams[0].gap, found [0.1]");
    EXPECT_NE(message(with("\"upright\":true", "\"upright\":1")).find("true or false"),
              std::string::npos);
    EXPECT_NE(message(with("0.000515", "\"0.000515\"")).find("a number"), std::string::npos);
    EXPECT_NE(message(with(",\"depth\":0.1", "")).find("expected a member"), std::string::npos);
    EXPECT_NE(message(with("\"width\"", "\"more\": 1,\"width\"")).find("no other members"),
              std::string::npos);
    EXPECT_NE(message(with("[1,2]", "[1,2", corridors)).find("c.json:"), std::string::npos);
}

TEST(VerdictFile, HasEveryClaim) {
    const test::TemporaryFolder folder;
    write_verdict(folder / "v", "p.txt", "c.json", {{{"ASVs", true, "7"}, {"digest", false, "x"}}});
    EXPECT_EQ(read_file(folder / "v"), R"({
  "problem": "p.txt",
  "certificate": "c.json",
  "accepted": false,
  "claims": [
    {
      "claim": "ASVs",
      "ok": true,
      "detail": "7"
    },
    {
      "claim": "digest",
      "ok": false,
      "detail": "x"
    }
  ]
}
)");
}

}  // namespace
}  // namespace asv::io
