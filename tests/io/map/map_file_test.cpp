#include "io/map/map_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"

namespace asv::io {
namespace {

using geometry::Grid;

/// The cells from the top line down, as text.
std::string picture(const Grid& grid) {
    std::string text;
    for (std::size_t y = grid.height; y-- > 0;) {
        for (std::size_t x = 0; x < grid.width; ++x) text += grid.occupied(x, y) ? '#' : '.';
        text += '\n';
    }
    return text;
}

std::string message(const std::string& content) {
    return test::error_message<ParseError>([&] { parse_map(content, "map"); });
}

TEST(MapFile, ReadsAPgmAsTextWithComments) {
    EXPECT_EQ(picture(parse_map("P2 # grey\n# a comment\n3 2\n255\n0 127 128\n255 10 200\n", "m")),
              "##.\n.#.\n");
}

TEST(MapFile, ReadsAPgmAsBytes) {
    EXPECT_EQ(picture(parse_map(std::string("P5\n3 2\n255\n\x00\x7f\x80\xff\x0a\xc8", 17), "m")),
              "##.\n.#.\n");
    // Two bytes for each pixel, the higher one first; and a white of its own.
    EXPECT_EQ(picture(parse_map(std::string("P5 2 1 1000\n\x01\xf0\x01\xf4", 16), "m")), "#.\n");
}

TEST(MapFile, ReadsTheOtherPicturesOfNetpbm) {
    const std::string expected = ".#.\n...\n";
    EXPECT_EQ(picture(parse_map("P1\n# black is 1\n3 2\n0 1 0\n000\n", "m")), expected);
    EXPECT_EQ(picture(parse_map(std::string("P4 3 2\n\x40\x00", 9), "m")), expected);
    EXPECT_EQ(picture(parse_map("P3 3 2 1  1 1 1  0 0 1  1 1 0  1 1 1  1 1 1  1 1 1", "m")),
              expected);
    EXPECT_EQ(picture(parse_map(std::string("P6 1 2 255\n\xff\xff\xff\0\0\0", 17), "m")), ".\n#\n");
    EXPECT_EQ(picture(parse_map("P1 10 2 1000000001 0100000000", "m")), "#........#\n.#........\n");
    EXPECT_EQ(picture(parse_map(std::string("P4 10 2\n\x80\x40\x40\x00", 12), "m")),
              "#........#\n.#........\n");
}

TEST(MapFile, ReadsAMapOfThePathfindingBenchmarks) {
    EXPECT_EQ(picture(parse_map("type octile\nheight 2\nwidth 5\nmap\n.G@OT\r\nSW..@\n", "m")),
              "..###\n.#..#\n");
    EXPECT_EQ(message("type octile\nheight 2\nwidth 2\nmap\n..\n.x"),
              "map:6:2: expected a cell (one of . G S W T @ O), found 'x'");
    EXPECT_EQ(message("type octile\nheight 2\nwidth 2\nmap\n..\n..\n."),
              "map:7:1: expected the end of the file after the last cell, found '.'");
    EXPECT_EQ(message("type octile\nheight 9\nwidth 9\nmap\n..\n"),
              "map:5:1: expected 81 cells, found '..'");
    EXPECT_EQ(message("type square\n"),
              "map:1:6: expected 'octile', the type of a map of 'height H' and 'width W', found "
              "'square'");
    EXPECT_EQ(message("type octile\nheight 1\nwidth 1\n."),
              "map:4:1: expected 'map' before the lines of the map, found '.'");
}

TEST(MapFile, ReadsAGridWithoutAHeaderOrWithAByteOrderMark) {
    EXPECT_EQ(picture(parse_map("0 0 0\n0 1 0\n\n0 0 0\n", "m")), "...\n.#.\n...\n");
    EXPECT_EQ(picture(parse_map("\xEF\xBB\xBF"
                                "01\r\n10",
                                "m")),
              ".#\n#.\n");
    EXPECT_EQ(picture(parse_map("\xEF\xBB\xBFheight 1\nwidth 2\n01", "m")), ".#\n");
}

TEST(MapFile, OnlyRegularFilesAreMaps) {
    EXPECT_EQ(test::error_message<ReadError>([] { read_map("/dev/zero"); }),
              "/dev/zero: not a regular file");
}

TEST(MapFile, TheThresholdCounts) {
    EXPECT_EQ(picture(parse_map("P2 3 1 255 99 100 101", "m", {0, 100})), "##.\n");
    EXPECT_EQ(picture(parse_map("P2 3 1 255 0 1 2", "m", {0, 0})), "#..\n");
}

TEST(MapFile, ReadsAGridOfDigits) {
    EXPECT_EQ(picture(parse_map("height 2\nwidth 3\n0 1 1\n0 0 1\n", "m")), ".##\n..#\n");
    EXPECT_EQ(picture(parse_map("width 3\r\nheight 2\r\n011\r\n001", "m")), ".##\n..#\n");
}

TEST(MapFile, ReadsAPngAndAGridOfTheTestcases) {
    const Grid town = read_map(ASV_SOURCE_DIR "/testcases/bodies/town.png");
    EXPECT_EQ(town.width, 300U);
    EXPECT_EQ(town.height, 200U);
    // A corner of the house in the upper left: pixels from (18, 16).
    EXPECT_TRUE(town.occupied(18, 199 - 16));
    EXPECT_FALSE(town.occupied(17, 199 - 16));
    EXPECT_FALSE(town.occupied(18, 199 - 15));
    const Grid workshop = read_map(ASV_SOURCE_DIR "/testcases/bodies/workshop.map");
    EXPECT_EQ(workshop.width, 50U);
    EXPECT_TRUE(workshop.occupied(8, 0));
    EXPECT_FALSE(workshop.occupied(25, 0));
}

TEST(MapFile, SaysWhatItCannotUnderstandAndWhere) {
    const std::string anything =
        "a picture (PBM, PGM, PPM or PNG), lines of digits 0 and 1, 'height H' and 'width W' "
        "before them, or 'type octile' before those";
    EXPECT_EQ(message(""), "map:1:1: expected " + anything + ", found the end of the file");
    EXPECT_EQ(message("height 2\nwide 3\n"), "map:2:1: expected " + anything + ", found 'wide'");
    EXPECT_EQ(message("\x7f"
                      "ELF\x01"),
              "map:1:1: expected " + anything + ", found bytes that are no text");
    EXPECT_EQ(message("height 1\nwidth 3\n0\x1b[31m0\n"),
              "map:3:2: expected 0 or 1, found bytes that are no text");
    EXPECT_EQ(
        message("010\n01\n000\n"),
        "map:2:3: expected 3 digits in each line, as in the first one, found the end of the line");
    EXPECT_EQ(message("P5 100000 100000 255\n"),
              "map:2:1: expected 10000000000 bytes of pixels, found the end of the file");
    EXPECT_EQ(message("P4 2 2\n\x80"),
              "map:2:2: expected 2 bytes of pixels, found the end of the file");
    EXPECT_EQ(message("height 1\nwidth 0\n"),
              "map:2:7: expected the width (a whole number from 1 to 1000000), found '0'");
    EXPECT_EQ(message("height 1\nwidth 3\n012\n"), "map:3:3: expected 0 or 1, found '2'");
    EXPECT_EQ(message("height 1\nwidth 2\n011\n"),
              "map:3:3: expected the end of the file after 2 digits, found '1'");
    EXPECT_EQ(message("height 2\nwidth 2\n011\n"),
              "map:4:1: expected 0 or 1, found the end of the file");
    EXPECT_EQ(message("P2 2 1 255\n0 256\n"),
              "map:2:3: expected a pixel (a whole number from 0 to 255), found '256'");
    EXPECT_EQ(
        message("P2 2 2 255\n0 1 2"),
        "map:2:6: expected a pixel (a whole number from 0 to 255), found the end of the file");
    EXPECT_EQ(message("P5 2 2 255\nab"),
              "map:2:3: expected 4 bytes of pixels, found the end of the file");
    EXPECT_NE(message("P5 1000000 1000000 255\nab").find("bytes of pixels"), std::string::npos);
    EXPECT_NE(message("\x89PNG\r\n\x1a\nnonsense").find("map:1:1: expected a PNG picture"),
              std::string::npos);
    EXPECT_THROW(read_map("/nonexistent/map.pgm"), ReadError);
}

}  // namespace
}  // namespace asv::io
