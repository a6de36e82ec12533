#include "io/text/escape.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/text/parse_error.hpp"
#include "io/text/warning.hpp"

namespace asv::io {
namespace {

TEST(Escape, LeavesWhatIsReadable) {
    for (const char* text : {"", "a b", "C:\\x", "ä€😀", "日本", "\xC2\xA0"})
        EXPECT_EQ(escaped(text), text);
}

TEST(Escape, ShowsTheBytesOfControls) {
    EXPECT_EQ(escaped("a\nb\x1b[31m\x7f"), "a\\x0Ab\\x1B[31m\\x7F");
    EXPECT_EQ(escaped(std::string(1, '\0')), "\\x00");
    EXPECT_EQ(escaped("\xC2\x9B"), "\\xC2\\x9B");                    // a control of 8 bits
    EXPECT_EQ(escaped("\xE2\x80\xAEtxt"), "\\xE2\\x80\\xAEtxt");     // right to left
    EXPECT_EQ(escaped("\xEF\xBB\xBF{"), "\\xEF\\xBB\\xBF{");         // byte order mark
    EXPECT_EQ(escaped("\xF3\xA0\x81\x81"), "\\xF3\\xA0\\x81\\x81");  // a tag
}

TEST(Escape, ShowsWhatIsNotUtf8) {
    EXPECT_EQ(escaped("\xFF"), "\\xFF");
    EXPECT_EQ(escaped("a\xC3"), "a\\xC3");
    EXPECT_EQ(escaped("\xC0\x80"), "\\xC0\\x80");           // too long
    EXPECT_EQ(escaped("\xED\xA0\x80"), "\\xED\\xA0\\x80");  // half of a pair
    EXPECT_EQ(escaped("\xE2\x82z"), "\\xE2\\x82z");
}

TEST(Escape, EveryMessageAboutAFileIsEscaped) {
    EXPECT_STREQ(ParseError("f\n", 1, 2, "x\r", "\x1b").what(),
                 "f\\x0A:1:2: expected x\\x0D, found \\x1B");
    EXPECT_STREQ(ReadError("\x1b: no").what(), "\\x1B: no");
    EXPECT_EQ(to_text({"\x1b", 1, 2, "\a"}), "\\x1B:1:2: warning: \\x07");
}

}  // namespace
}  // namespace asv::io
