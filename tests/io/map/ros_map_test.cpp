#include "io/map/ros_map.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"

namespace asv::io {
namespace {

/// As map_saver writes it.
const std::string saved =
    "image: office.pgm\n"
    "mode: trinary\n"
    "resolution: 0.05\n"
    "origin: [-10, -5.5, 0]\n"
    "negate: 0\n"
    "occupied_thresh: 0.65\n"
    "free_thresh: 0.25\n";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = saved;
    return text.replace(text.find(from), from.size(), to);
}

std::string complaint(const std::string& content) {
    return test::error_message<ParseError>([&] { parse_ros_map(content, "m.yaml"); });
}

TEST(RosMap, HoldsWhatMapSaverWrites) {
    const RosMap map = parse_ros_map(saved, "m.yaml");
    EXPECT_EQ(map.image, "office.pgm");
    EXPECT_EQ(map.resolution, 0.05);
    EXPECT_EQ(map.origin, (geometry::Point{-10, -5.5}));
    EXPECT_FALSE(map.negated);
    EXPECT_EQ(map.occupied_thresh, 0.65);
    EXPECT_EQ(map.free_thresh, 0.25);
    EXPECT_TRUE(map.warnings.empty());
}

TEST(RosMap, MayBeWrittenInOtherWays) {
    const RosMap map = parse_ros_map(
        "# a comment\n---\nfree_thresh: 1.96e-1   # another\nimage: \"a map#1: x.png\"\norigin:\n- "
        "-1\n"
        "- 2.5\n- 0.0\nnegate: true\r\noccupied_thresh: .65\nresolution: 1\nfloor: [3, 4]\n",
        "m.yaml");
    EXPECT_EQ(map.image, "a map#1: x.png");
    EXPECT_EQ(map.origin, (geometry::Point{-1, 2.5}));
    EXPECT_TRUE(map.negated);
    EXPECT_EQ(map.free_thresh, 0.196);
    ASSERT_EQ(map.warnings.size(), 1U);
    EXPECT_EQ(to_text(map.warnings[0]), "m.yaml:12:8: warning: 'floor' is passed over");
}

TEST(RosMap, ThresholdsAreThoseOfTheMapServer) {
    // Occupied is (255 - grey) / 255 > 0.6, free is less than 0.2; neither is unknown.
    RosMap map;
    map.occupied_thresh = 0.6;
    map.free_thresh = 0.2;
    EXPECT_TRUE(map.occupied(false).hold(101));
    EXPECT_FALSE(map.occupied(false).hold(102));  // exactly 0.6
    EXPECT_TRUE(map.occupied(true).hold(204));    // exactly 0.2
    EXPECT_FALSE(map.occupied(true).hold(205));
    map.negated = true;
    EXPECT_TRUE(map.occupied(false).hold(154));
    EXPECT_FALSE(map.occupied(false).hold(153));
    EXPECT_TRUE(map.occupied(true).hold(51));
    EXPECT_FALSE(map.occupied(true).hold(50));
}

TEST(RosMap, SaysWhatItCannotUnderstandAndWhere) {
    EXPECT_EQ(complaint(changed("0]", "0.5]")),
              "m.yaml:4:21: expected the angle 0, since obstacles are not turned, found '0.5'");
    EXPECT_EQ(complaint(changed(", 0]", "]")),
              "m.yaml:4:9: expected [x, y, angle] of the lower left corner, found a list or names");
    EXPECT_EQ(complaint(changed("[-10, -5.5, 0]", "here")),
              "m.yaml:4:9: expected [x, y, angle] of the lower left corner, found 'here'");
    EXPECT_EQ(complaint(changed("-5.5", "five")),
              "m.yaml:4:15: expected a coordinate, found 'five'");
    EXPECT_EQ(complaint(changed("trinary", "raw")),
              "m.yaml:2:7: expected 'trinary' or 'scale' ('raw' has no thresholds), found 'raw'");
    EXPECT_EQ(complaint(changed("0.05", "0")),
              "m.yaml:3:13: expected the side of a pixel, above 0, found '0'");
    EXPECT_EQ(complaint(changed("0.65", "65 %")),
              "m.yaml:6:18: expected a number from 0 to 1, found '65 %'");
    EXPECT_EQ(complaint(changed("0.25", "0.7")),
              "m.yaml:7:14: expected a number from 0 to occupied_thresh, found '0.7'");
    EXPECT_EQ(complaint(changed("negate: 0", "negate: no")),
              "m.yaml:5:9: expected 0 or 1, false or true, found 'no'");
    EXPECT_EQ(complaint(changed("office.pgm", "[]")),
              "m.yaml:1:8: expected the name of a picture, found a list or names");
    EXPECT_EQ(complaint(changed("negate: 0\n", "")),
              "m.yaml:7:1: expected a line 'negate: ...', found none");
    EXPECT_EQ(complaint(changed("mode: trinary", "negate: 0")),
              "m.yaml:5:1: expected each name once, found 'negate'");
    EXPECT_EQ(complaint(changed("mode: trinary", "? [a]\n: b")),
              "m.yaml:2:3: expected a name, found a list or names");
    EXPECT_EQ(complaint(changed("office.pgm", "\"office")),
              "m.yaml:8:1: expected YAML, found found unexpected end of stream");
    const std::string anything =
        "m.yaml:1:1: expected names and values, as in 'resolution: 0.05', found something else";
    EXPECT_EQ(complaint(""), anything);
    EXPECT_EQ(complaint("- 3\n"), anything);
}

}  // namespace
}  // namespace asv::io
