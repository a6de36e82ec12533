#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/problem/scenario_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// Maps of scenarios: what a map.yaml of ROS says, and lines that are columns.

namespace asv::io {
namespace {

using geometry::Box;

/// The picture has obstacles (0), unknown cells (205) and free ones (254), as map_saver has them.
const std::string office = "P2 3 2 255\n0 205 254\n254 254 254\n";
const std::string office_yaml =
    "image: office.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

class ScenarioMaps : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& content) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        write_file(folder_ / name, content);
    }

    ProblemFile read(const std::string& map, bool anywhere = false) const {
        const std::string text = R"({"version": 1, "body": {"kind": "point"}, "map": )" + map +
                                 R"(, "start": [0.25, 2.25], "goal": [0.3, 2.3]})";
        return parse_scenario(text, "s.json", folder_.path(), {.maps_anywhere = anywhere});
    }

    std::string refusal(const std::string& map) const {
        return test::error_message<ParseError>([&] { read(map); });
    }

    test::TemporaryFolder folder_;
};

TEST_F(ScenarioMaps, OfRosHaveTheirPlaceAndTellOfUnknownCells) {
    write("maps/office.pgm", office);
    write("maps/office.yaml", office_yaml);
    const ProblemFile file = read(R"({"file": "maps/office.yaml"})");
    EXPECT_EQ(file.problem.obstacles, (std::vector<Box>{{{-1, 2.5}, {0, 3}}}));
    EXPECT_EQ(file.problem.requirements.bounds, (Box{{-1, 2}, {0.5, 3}}));
    ASSERT_EQ(file.warnings.size(), 1U);
    EXPECT_EQ(
        file.warnings[0].message,
        "unknown cells (1) are taken for obstacles, which a member \"unknown\" can say at map");
    ASSERT_EQ(file.maps.size(), 2U);
    EXPECT_EQ(file.maps[0].filename(), "office.yaml");
    EXPECT_EQ(file.maps[1].filename(), "office.pgm");
}

TEST_F(ScenarioMaps, OfRosHaveUnknownCellsAsTheScenarioSays) {
    write("office.pgm", office);
    write("office.yml", office_yaml);
    const ProblemFile free = read(R"({"file": "office.yml", "unknown": "free"})");
    EXPECT_EQ(free.problem.obstacles, (std::vector<Box>{{{-1, 2.5}, {-0.5, 3}}}));
    EXPECT_TRUE(free.warnings.empty());
    const ProblemFile obstacle = read(R"({"file": "office.yml", "unknown": "obstacle"})");
    EXPECT_EQ(obstacle.problem.obstacles, (std::vector<Box>{{{-1, 2.5}, {0, 3}}}));
    EXPECT_TRUE(obstacle.warnings.empty());
}

TEST_F(ScenarioMaps, OfRosAreRefusedWithAReason) {
    write("office.pgm", office);
    write("office.yaml", office_yaml);
    EXPECT_NE(refusal(R"({"file": "office.yaml", "cell": 2})")
                  .find("expected no such member, since the map.yaml tells it at map.cell"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"file": "office.yaml", "unknown": "maybe"})")
                  .find("expected \"obstacle\" or \"free\" at map.unknown"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"file": "office.pgm", "unknown": "free"})")
                  .find("expected no such member, but for a map.yaml of ROS at map.unknown"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"file": "missing.yaml"})").find("a map that can be read"),
              std::string::npos);
    write("away.yaml", "image: ../office.pgm" + office_yaml.substr(office_yaml.find('\n')));
    EXPECT_NE(refusal(R"({"file": "away.yaml"})")
                  .find("a map.yaml whose image is below the folder of the scenario"),
              std::string::npos);
    const std::string absolute = (folder_ / "office.pgm").string();
    write("absolute.yaml", "image: " + absolute + office_yaml.substr(office_yaml.find('\n')));
    EXPECT_NE(
        refusal(R"({"file": "absolute.yaml"})").find("a map.yaml whose image is a relative path"),
        std::string::npos);
    EXPECT_EQ(read(R"({"file": "absolute.yaml"})", true).problem.obstacles.size(), 1U);
}

TEST_F(ScenarioMaps, MayHaveLinesForColumnsAndTheFirstLineBelow) {
    write("m.txt", "110\n000\n");
    const auto obstacles = [&](const std::string& more) {
        return read(R"({"file": "m.txt")" + more + "}").problem.obstacles;
    };
    EXPECT_EQ(obstacles(""), (std::vector<Box>{{{0, 1}, {2, 2}}}));
    EXPECT_EQ(obstacles(R"(, "flip": true)"), (std::vector<Box>{{{0, 0}, {2, 1}}}));
    EXPECT_EQ(obstacles(R"(, "transpose": true)"), (std::vector<Box>{{{0, 1}, {1, 3}}}));
    // Cell j of line i is at x = i, y = j then.
    EXPECT_EQ(obstacles(R"(, "transpose": true, "flip": true)"),
              (std::vector<Box>{{{0, 0}, {1, 2}}}));
    EXPECT_EQ(obstacles(R"(, "transpose": false, "flip": false)"), obstacles(""));
    EXPECT_EQ(read(R"({"file": "m.txt", "transpose": true})").problem.requirements.bounds,
              (Box{{0, 0}, {2, 3}}));
}

}  // namespace
}  // namespace asv::io
