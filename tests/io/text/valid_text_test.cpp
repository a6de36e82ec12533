#include "io/text/valid_text.hpp"

#include <gtest/gtest.h>

namespace asv::io {
namespace {

TEST(ValidText, IsKeptAsItIs) {
    for (const char* text :
         {"", "7ASV.txt", "gr\u00f6\u00dfer", "\u2026", "\U0001F6A2", "\uD7FF", "\U0010FFFF"})
        EXPECT_EQ(valid_text(text), text);
}

TEST(ValidText, OtherBytesAreReplacedOneByOne) {
    EXPECT_EQ(valid_text("q\xff.txt"), "q\uFFFD.txt");
    EXPECT_EQ(valid_text("\xc3"), "\uFFFD") << "cut off";
    EXPECT_EQ(valid_text("\xc0\xaf"), "\uFFFD\uFFFD") << "longer than it need be";
    EXPECT_EQ(valid_text("\xe0\x80\xaf"), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(valid_text("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "half of a pair";
    EXPECT_EQ(valid_text("\xf4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond the last";
}

TEST(ValidText, ControlCharactersAreBlanks) {
    EXPECT_EQ(valid_text(std::string_view("a\0b\x1b[1m\n\x7f", 9)), "a b [1m  ");
}

}  // namespace
}  // namespace asv::io
