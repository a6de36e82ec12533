#include "io/solution/validation_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using core::Check;
using core::CheckResult;
using core::Offender;
using nlohmann::json;

json written(const ValidationSummary& summary) {
    const test::TemporaryFolder folder;
    write_validation(folder / "j", summary);
    return json::parse(read_file(folder / "j"));
}

CheckResult failed_collision() {
    Offender offender;
    offender.state = 4;
    offender.broom = 1;
    offender.obstacle = 0;
    offender.time = 0.5;
    offender.room = -0.25;
    CheckResult result;
    result.check = Check::collisions;
    result.states = 9;
    result.failures = 1;
    result.worst = offender;
    result.offenders = {offender};
    return result;
}

TEST(ValidationFile, HoldsEveryCheckOfAPath) {
    core::ValidationReport report;
    report.cost = 1.5;
    CheckResult ends;
    ends.states = 2;
    report.checks = {ends};
    report.motion = {failed_collision()};
    const json file = written({"p.txt", "s.txt", 1e-5, {{"path", 2, report}}});
    EXPECT_EQ(file["problem"], "p.txt");
    EXPECT_EQ(file["solution"], "s.txt");
    EXPECT_EQ(file["tolerance"], 1e-5);
    EXPECT_EQ(file["valid"], false);
    const json& part = file["parts"].at(0);
    EXPECT_EQ(part["name"], "path");
    EXPECT_EQ(part["valid"], false);
    EXPECT_EQ(part["cost"], 1.5);
    EXPECT_EQ(part["checks"].at(0),
              json::parse(R"({"check": "ends", "ok": true, "states": 2, "failures": 0,
                              "worst": null, "offenders": []})"));
    const json offender = json::parse(R"({"state": 4, "line": 6, "broom": 2, "obstacle": 1,
                                          "time": 0.5, "room": -0.25})");
    EXPECT_EQ(part["motion"].at(0)["check"], "collisions");
    EXPECT_EQ(part["motion"].at(0)["failures"], 1);
    EXPECT_EQ(part["motion"].at(0)["worst"], offender);
    EXPECT_EQ(part["motion"].at(0)["offenders"], json::array({offender}));
}

TEST(ValidationFile, ALineThatIsNotKnownIsNull) {
    core::ValidationReport report;
    report.checks = {failed_collision()};
    const json file = written({"p", "s", 0, {{"trajectory", std::nullopt, report}}});
    EXPECT_TRUE(file["parts"].at(0)["checks"].at(0)["worst"]["line"].is_null());
}

TEST(ValidationFile, StartAndGoalHaveNoSolution) {
    const json file = written({"p", "", 0, {{"start", 2, {}}, {"goal", 3, {}}}});
    EXPECT_TRUE(file["solution"].is_null());
    EXPECT_EQ(file["valid"], true);
    EXPECT_EQ(file["parts"].size(), 2U);
}

TEST(ValidationFile, LinesAreThoseOfTheFileThatWasChecked) {
    Offender offender;
    EXPECT_EQ((ValidatedPart{"goal", 3, {}}.line(Check::area, offender)), 3U);
    offender.state = 7;
    EXPECT_EQ((ValidatedPart{"path", 2, {}}.line(Check::area, offender)), 9U);
    EXPECT_EQ((ValidatedPart{"path", 2, {}}.line(Check::cost, offender)), 1U);
}

TEST(ValidationFile, NamesThatAreNoUtf8AreStillWritten) {
    EXPECT_EQ(written({"\xFF.txt", "", 0, {}})["problem"], "\xEF\xBF\xBD.txt");
}

}  // namespace
}  // namespace asv::io
