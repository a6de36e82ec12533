#include "io/drawing/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/drawing/paint/page.hpp"
#include "tests/kit/files/drawing_samples.hpp"
#include "tests/kit/files/text.hpp"

namespace asv::io {
namespace {

using test::Box;
using test::Point;
using test::sample;
using test::two_walls;

TEST(Page, HasOneScaleWhateverIsAboveAndBelow) {
    const Box unit{{0, 0}, {1, 1}};
    const Page plain(unit, 0, 40);
    const Page full(unit, 6, 240);
    EXPECT_EQ(plain.scale, 800);
    EXPECT_EQ(full.scale, 800);
    EXPECT_EQ(plain.width, full.width);
    EXPECT_EQ(plain.field.high.x - plain.field.low.x, 800);
    EXPECT_EQ(plain.at(Point{0, 1}), plain.field.low) << "y grows upwards in the field";
    EXPECT_EQ(plain.at(Point{1, 0}), plain.field.high);
    const Page wide({{-10, 0}, {290, 200}}, 0, 40);
    EXPECT_EQ(wide.field.high.x - wide.field.low.x, 800);
    EXPECT_NEAR(wide.field.high.y - wide.field.low.y, 800 * 200 / 300.0, 1e-9);
}

TEST(Picture, IsTheFileThatItsNameSays) {
    const Exhibit exhibit = make_exhibit(sample(5, {{0.1, 0.3}, {0.7, 0.3}}, two_walls()));
    EXPECT_TRUE(draw_picture(exhibit, PictureFormat::svg, Theme::light).starts_with("<?xml"));
    EXPECT_TRUE(draw_picture(exhibit, PictureFormat::pdf, Theme::light).starts_with("%PDF"));
    const std::string png = draw_picture(exhibit, PictureFormat::png, Theme::dark);
    ASSERT_TRUE(png.starts_with("\x89PNG"));
    const auto big_endian = [&](std::size_t at) {
        std::size_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value * 256 + static_cast<unsigned char>(png[at + i]);
        return value;
    };
    EXPECT_EQ(big_endian(16), 1760U) << "two pixels a point";
}

/// As an svg has a colour.
std::string svg_colour(const Colour& colour) {
    const auto percent = [](double share) {
        std::ostringstream out;
        out << std::fixed;
        out.precision(2);
        out << 100 * share;
        return std::regex_replace(std::regex_replace(out.str(), std::regex("0+$"), ""),
                                  std::regex("\\.$"), "") +
               "%";
    };
    return "rgb(" + percent(colour.red) + "," + percent(colour.green) + "," + percent(colour.blue) +
           ")";
}

TEST(Picture, SvgHasTheObstaclesTheWaysAndTheMark) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Exhibit exhibit = make_exhibit(sample(5, {{0.1, 0.3}, {0.7, 0.3}}, two_walls()));
        const std::string svg = draw_picture(exhibit, PictureFormat::svg, theme);
        const Palette& colours = palette(theme);
        std::smatch match;
        // The fill of the field comes first, and again in the inset.
        const std::regex obstacles(
            "<path [^>]*fill:" +
            std::regex_replace(svg_colour(colours.obstacle), std::regex("([().])"), "\\$1") +
            ";[^>]* d=\"([^\"]*)\"");
        ASSERT_TRUE(std::regex_search(svg, match, obstacles));
        EXPECT_EQ(test::count(match[1], "Z"), two_walls().size());
        EXPECT_GE(test::count(svg, "stroke:" + svg_colour(colours.least)), 2U)
            << "in the field and below it";
        EXPECT_EQ(test::count(svg, "stroke:" + svg_colour(colours.violation)), 0U);
        EXPECT_NE(svg.find("<title>sample</title>"), std::string::npos);
        EXPECT_NE(svg.find("role=\"img\""), std::string::npos);
        EXPECT_NE(svg.find("width=\"880px\""), std::string::npos);
        // What the texts say keeps its digits.
        const std::string drawing =
            std::regex_replace(svg.substr(svg.find("</desc>")), std::regex(">[^<]*</text>"), "");
        EXPECT_FALSE(std::regex_search(drawing, std::regex("[0-9]\\.[0-9]{3}"))) << "short numbers";
        EXPECT_LT(svg.size(), 1000000U);
    }
}

/// What the text elements of an svg say.
std::vector<std::string> texts_of(const std::string& svg) {
    const std::regex element("<text [^>]*>([^<]*)</text>");
    std::vector<std::string> texts;
    for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it)
        texts.push_back((*it)[1]);
    return texts;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

TEST(Picture, SvgHasItsWordsAsText) {
    const Exhibit exhibit = make_exhibit(sample(5, {{0.1, 0.3}, {0.7, 0.3}}, two_walls()));
    const std::string svg = draw_picture(exhibit, PictureFormat::svg, Theme::light);
    const std::vector<std::string> texts = texts_of(svg);
    for (const std::string& wanted : {std::string("sample"), std::string("✓ valid"), facts(exhibit),
                                      std::string("start"), std::string("goal"), std::string("0.2"),
                                      std::string("share of the cost, from start to goal")})
        EXPECT_TRUE(has(texts, wanted)) << wanted;
    EXPECT_EQ(svg.find("<symbol"), std::string::npos) << "no outlines of letters";
    EXPECT_EQ(svg.find("glyph"), std::string::npos) << "no outlines of letters";
}

TEST(Picture, NumbersObstaclesWhereThereIsRoomAndTheyAreFew) {
    const auto numbers = [](std::vector<Box> boxes) {
        ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, std::move(boxes));
        input.solution.reset();
        const Exhibit exhibit = make_exhibit(std::move(input));
        return texts_of(draw_picture(exhibit, PictureFormat::svg, Theme::light));
    };
    const std::vector<std::string> apart =
        numbers({{{0.5, 0.5}, {0.6, 0.6}}, {{0.7, 0.7}, {0.705, 0.9}}, {{0.8, 0.8}, {0.9, 0.9}}});
    EXPECT_TRUE(has(apart, "1"));
    EXPECT_FALSE(has(apart, "2")) << "too thin for its number";
    EXPECT_TRUE(has(apart, "3"));
    const std::vector<std::string> crossed =
        numbers({{{0.4, 0.68}, {0.9, 0.72}}, {{0.63, 0.5}, {0.67, 0.9}}});
    EXPECT_FALSE(has(crossed, "1") || has(crossed, "2")) << "both would stand in one place";
    std::vector<Box> many;
    for (int i = 0; i < 64; ++i) {
        const Point low{0.45 + 0.06 * (i % 8), 0.45 + 0.06 * (i / 8)};
        many.push_back({low, {low.x + 0.05, low.y + 0.05}});
    }
    EXPECT_FALSE(has(numbers(many), "1"));
}

TEST(Picture, AThumbnailIsTheFieldAlone) {
    const Exhibit exhibit = make_exhibit(sample(5, {{0.1, 0.3}, {0.7, 0.3}}, two_walls()));
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const std::string svg = draw_thumbnail(exhibit, theme);
        EXPECT_TRUE(texts_of(svg).empty());
        EXPECT_NE(svg.find("width=\"400px\" height=\"400px\""), std::string::npos);
        EXPECT_NE(svg.find("<title>sample</title>"), std::string::npos);
        EXPECT_NE(svg.find(svg_colour(palette(theme).obstacle)), std::string::npos);
    }
    ExhibitInput wide = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    wide.problem.requirements.bounds = {{0, 0}, {2, 1}};
    EXPECT_NE(draw_thumbnail(make_exhibit(std::move(wide)), Theme::light)
                  .find("width=\"400px\" height=\"200px\""),
              std::string::npos);
}

TEST(Picture, TakesAnyNameAndEscapesIt) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    input.name = "a<b>&\"'\n\xFF" + std::string(300, 'w');
    const Exhibit exhibit = make_exhibit(std::move(input));
    const std::string svg = draw_picture(exhibit, PictureFormat::svg, Theme::light);
    EXPECT_NE(svg.find("<title>a&lt;b&gt;&amp;&quot;&#39; \xEF\xBF\xBDwww"), std::string::npos);
}

TEST(Picture, HoldsAHundredThousandObstacles) {
    std::vector<Box> boxes;
    for (int i = 0; i < 100000; ++i) {
        const double x = 0.5 + 0.0015 * (i % 300);
        const double y = 0.5 + 0.0015 * (i / 300);
        boxes.push_back({{x, y}, {x + 0.001, y + 0.001}});
    }
    const Exhibit exhibit = make_exhibit(sample(7, {{0.1, 0.1}, {0.3, 0.1}}, std::move(boxes)));
    EXPECT_LT(draw_picture(exhibit, PictureFormat::svg, Theme::light).size(), 20000000U);
    EXPECT_FALSE(draw_picture(exhibit, PictureFormat::png, Theme::light).empty());
}

double luminance(const Colour& colour) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) +
           0.0722 * linear(colour.blue);
}

double contrast(const Colour& a, const Colour& b) {
    const double high = std::max(luminance(a), luminance(b));
    const double low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

TEST(Palette, MeetsTheContrastThatItPromises) {
    for (const Palette& colours : {light_palette, dark_palette}) {
        for (const Colour& text : {colours.ink, colours.muted, colours.start, colours.goal,
                                   colours.least, colours.violation}) {
            EXPECT_GE(contrast(text, colours.page), 4.5);
            EXPECT_GE(contrast(text, colours.field), 4.5);
        }
        EXPECT_GE(contrast(colours.obstacle, colours.field), 3);
        EXPECT_GE(contrast(colours.ink, colours.obstacle), 4.5);
    }
}

TEST(Picture, ShowsWhyThereIsNoPath) {
    const Exhibit exhibit = make_exhibit(test::low_corridor());
    ASSERT_EQ(exhibit.feasibility.closed.size(), 1U);
    const Box closed = exhibit.feasibility.closed[0];
    EXPECT_GT(closed.low.x, 0.44) << "half a chain from the mouth";
    EXPECT_LT(closed.high.x, 0.56);
    EXPECT_NEAR(closed.low.y, 0.5, 0.001);
    EXPECT_NEAR(closed.high.y, 0.51, 0.001);
    EXPECT_EQ(verdict(exhibit), "there is no path");
    const std::string svg = draw_picture(exhibit, PictureFormat::svg, Theme::light);
    for (const char* words :
         {"there is no path", "no chain of 3 ASVs passes the corridor between obstacles 1 and 2",
          "no room: the middle of the chain cannot get here"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;

    ExhibitInput open = test::low_corridor();
    open.problem.obstacles[1].low.y = 0.6;
    EXPECT_EQ(verdict(make_exhibit(open)), "start and goal are valid");
}

TEST(Palette, IsTheOneOfThePlayer) {
    std::ifstream file(std::string(ASV_SOURCE_DIR) + "/io/player/page/player.css");
    std::stringstream css;
    css << file.rdbuf();
    const std::string text = css.str();
    const auto colours_of = [](const Palette& p) {
        return std::array<std::pair<std::string, Colour>, 10>{{{"page", p.page},
                                                               {"field", p.field},
                                                               {"ink", p.ink},
                                                               {"muted", p.muted},
                                                               {"grid", p.grid},
                                                               {"obstacle", p.obstacle},
                                                               {"start", p.start},
                                                               {"goal", p.goal},
                                                               {"least", p.least},
                                                               {"violation", p.violation}}};
    };
    const std::size_t dark = text.find("prefers-color-scheme: dark");
    ASSERT_NE(dark, std::string::npos);
    for (const auto& [part, colours] :
         {std::pair{text.substr(0, dark), light_palette}, {text.substr(dark), dark_palette}}) {
        for (const auto& [name, colour] : colours_of(colours)) {
            std::array<char, 16> hex{};
            std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x",
                          static_cast<unsigned>(std::lround(255 * colour.red)),
                          static_cast<unsigned>(std::lround(255 * colour.green)),
                          static_cast<unsigned>(std::lround(255 * colour.blue)));
            EXPECT_NE(part.find("--" + name + ": " + hex.data() + ";"), std::string::npos)
                << name << " " << hex.data();
        }
    }
}

}  // namespace
}  // namespace asv::io
