#include "io/solution/trajectory_file.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

using core::Trajectory;
using Format = TrajectoryFormat;

/// Two vehicles; the second one rests at first.
const Trajectory two_vehicles{
    test::path_of({{{0, 0}, {5, 0}}, {{1, 0}, {5, 0}}, {{1, 1}, {5, -1e-5}}}),
    {0, 1, 2.9999999999}};

TEST(TrajectoryFormat, IsToldByTheEnding) {
    EXPECT_EQ(trajectory_format("a.csv"), Format::csv);
    EXPECT_EQ(trajectory_format("a.b/c.json"), Format::json);
    EXPECT_EQ(trajectory_format("a.yaml"), Format::yaml);
    EXPECT_EQ(trajectory_format("a.yml"), Format::yaml);
    EXPECT_EQ(trajectory_format("-"), Format::csv);
    for (const char* other : {"a", "csv", "a.csv.txt", "a.CSV", "/dev/stdout"})
        EXPECT_EQ(trajectory_format(other), std::nullopt) << other;
}

TEST(FormatTrajectory, AsCsvHasALineForEachSample) {
    const auto lines = test::lines_of(format_trajectory(two_vehicles, Format::csv));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], "time,x1,y1,heading1,speed1,x2,y2,heading2,speed2");
    EXPECT_TRUE(lines[1].starts_with("0,0,0,0,0,5,0,-1.57079632679489")) << lines[1];
    EXPECT_TRUE(lines[2].starts_with("1,1,0,0.785398163397448")) << lines[2];
    EXPECT_TRUE(lines[3].starts_with("2.9999999999,1,1,1.57079632679489")) << lines[3];
    EXPECT_TRUE(lines[3].ends_with(",0")) << "at rest: " << lines[3];
}

TEST(FormatTrajectory, AsJsonHoldsTheSame) {
    const auto file = nlohmann::json::parse(format_trajectory(two_vehicles, Format::json));
    EXPECT_EQ(file["version"], 1);
    EXPECT_EQ(file["asv_count"], 2);
    EXPECT_EQ(file["duration"], 2.9999999999);
    ASSERT_EQ(file["samples"].size(), 3U);
    const auto& middle = file["samples"][1];
    EXPECT_EQ(middle["time"], 1);
    EXPECT_EQ(middle["positions"], nlohmann::json::parse("[[1, 0], [5, 0]]"));
    EXPECT_NEAR(middle["headings"][0].get<double>(), 0.785398, 1e-6);
    EXPECT_NEAR(middle["speeds"][0].get<double>(), 0.471405, 1e-6);
}

TEST(FormatTrajectory, AsYamlIsAPathOfRosForEachVehicle) {
    const std::string text = format_trajectory(two_vehicles, Format::yaml);
    EXPECT_EQ(test::count(text, "---\n"), 2U);
    EXPECT_EQ(test::count(text, "\nposes:\n- {header:"), 2U);
    EXPECT_EQ(test::count(text, "frame_id: map"), 8U);
    const auto lines = test::lines_of(text);
    EXPECT_EQ(lines[2], "header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}");
    // Headed along y; a time to the nearest nanosecond; every number with a point.
    EXPECT_EQ(lines[6],
              "- {header: {stamp: {sec: 3, nanosec: 0}, frame_id: map}, pose: {position: {x: 1.0, "
              "y: 1.0, z: 0.0}, orientation: {x: 0.0, y: 0.0, z: 0.7071067811865475, w: "
              "0.7071067811865476}}}");
    EXPECT_TRUE(test::contains(lines[13], "y: -1.0e-05, z: 0.0}")) << lines[13];
}

TEST(ReadTrajectory, CsvAndJsonReadBackToTheSameNumbers) {
    for (const TrajectoryFormat format : {Format::csv, Format::json}) {
        const TrajectoryFile read =
            parse_trajectory(format_trajectory(two_vehicles, format), 2, "t");
        EXPECT_EQ(read.trajectory.states, two_vehicles.states);
        EXPECT_EQ(read.trajectory.times, two_vehicles.times);
        EXPECT_EQ(read.first_line, 2U);
    }
}

TEST(ReadTrajectory, LinesAreToldOnlyWhereEachSampleHasOne) {
    const std::string laid_out =
        nlohmann::json::parse(format_trajectory(two_vehicles, Format::json)).dump(1);
    EXPECT_EQ(parse_trajectory(laid_out, 2, "t").first_line, std::nullopt);
}

TEST(ReadTrajectory, ReadsWhatOtherProgramsMakeOfTheLines) {
    const std::string text = "time,x1,y1,heading1,speed1\r\n 0, 1, 2, 0, 0\r\n1,1,3,0,0\r\n\r\n";
    const Trajectory read = parse_trajectory(text, 1, "t").trajectory;
    EXPECT_EQ(read.times, (std::vector<double>{0, 1}));
    EXPECT_EQ(read.states, test::path_of({{{1, 2}}, {{1, 3}}}));
}

std::string message(const std::string& text, std::size_t vehicles) {
    return test::error_message<ParseError>([&] { parse_trajectory(text, vehicles, "t"); });
}

TEST(ReadTrajectory, NamesThePlaceOfAMistakeInCsv) {
    const std::string header = "time,x1,y1,heading1,speed1\n";
    EXPECT_EQ(message("", 1),
              "t:1:1: expected a trajectory of 1 vehicle: JSON, or CSV with the columns "
              "time,x1,y1,heading1,speed1,..., found end of file");
    EXPECT_EQ(message(header + "0,1,2,0,0\n", 2),
              "t:1:27: expected a trajectory of 2 vehicles: JSON, or CSV with the columns "
              "time,x1,y1,heading1,speed1,..., found 'time,x1,y1,heading1,speed1'");
    EXPECT_EQ(message(header, 1), "t:2:1: expected a sample, found end of file");
    EXPECT_EQ(message(header + "0,1,two,0,0\n", 1),
              "t:2:5: expected a number (y of vehicle 1), found \"two\"");
    EXPECT_EQ(message(header + "0,1,2,0,0\nnan,1,2,0,0\n", 1),
              "t:3:1: expected a number (time), found \"nan\" (not a number)");
    EXPECT_EQ(message(header + "0,1,2,0\n", 1),
              "t:2:8: expected a number (speed of vehicle 1), found end of file");
    EXPECT_EQ(message(header + "0,1,2,0,0,7\n", 1),
              "t:2:11: expected the end of the line behind the speed of vehicle 1, found \"7\"");
}

TEST(ReadTrajectory, NamesThePlaceOfAMistakeInJson) {
    const auto one = [](const std::string& samples) {
        return R"({"version": 1, "asv_count": 1, "samples": [)" + samples + "]}";
    };
    EXPECT_EQ(message(one(""), 1), "t:1:43: expected at least one sample at samples, found []");
    EXPECT_EQ(message(one(R"({"time": 0, "positions": [[0, 0]]})"), 2),
              "t:1:29: expected the integer 2 at asv_count, found 1");
    EXPECT_EQ(message(one(R"({"positions": [[0, 0]]})"), 1),
              "t:1:44: expected a number at samples[0].time, found nothing");
    EXPECT_EQ(message(one(R"({"time": 0, "positions": [[0, 0], [1, 1]]})"), 1),
              "t:1:69: expected an array of 1 points [x, y], one for each vehicle at "
              "samples[0].positions, found [[0,0],[1,1]]");
    EXPECT_EQ(message(one(R"({"time": 0, "positions": [[0, 1e99]]})"), 1),
              "t:1:70: expected a point [x, y] at samples[0].positions[0], found [0,1e+99]");
}

TEST(ReadTrajectory, RefusesNoVehicles) {
    EXPECT_THROW(parse_trajectory("", 0, "t"), std::invalid_argument);
}

TEST(WriteTrajectory, RefusesStampsThatRosDoesNotHold) {
    const test::TemporaryFolder folder;
    Trajectory slow = two_vehicles;
    slow.times = {0, 1, 2147483647};
    EXPECT_NO_THROW(write_trajectory(folder / "a.yaml", slow, Format::yaml));
    slow.times.back() = 2147483648;
    EXPECT_THROW(write_trajectory(folder / "b.yaml", slow, Format::yaml), WriteError);
    EXPECT_NO_THROW(write_trajectory(folder / "b.csv", slow, Format::csv));
    EXPECT_EQ(folder.entries(), 2);
}

TEST(WriteTrajectory, WritesWhatReadsBack) {
    const test::TemporaryFolder folder;
    write_trajectory(folder / "t.json", two_vehicles, Format::json);
    EXPECT_EQ(read_trajectory(folder / "t.json", 2).trajectory.times, two_vehicles.times);
    EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace asv::io
