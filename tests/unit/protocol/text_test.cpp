// Requirement: whatever bytes a file, a name or a peer brings, a message about them is valid UTF-8 on one
// line.
#include "protocol/text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "protocol/excerpt.hpp"

namespace adit::protocol::text_test {
namespace {

constexpr const char* kUmlauts = "\xc3\xa4\xc3\xb6\xc3\xbc";  // äöü in UTF-8

TEST(Text, Utf8StaysAsItIs) {
  const std::string text = std::string("Tunnel ") + kUmlauts + " \xe9\x9a\xa7\xe9\x81\x93 \xf0\x9f\x9a\x87";
  EXPECT_EQ(valid_utf8(text), text);
  EXPECT_EQ(one_line(text), text);
  EXPECT_EQ(shorten(text), text);
}

// A wrong byte is replaced, and the characters around it stay: Latin-1, a character cut short, the overlong
// slash, a surrogate, beyond Unicode.
TEST(Text, BytesThatAreNotUtf8AreReplacedOneByOne) {
  const std::string r = "\xef\xbf\xbd";
  EXPECT_EQ(one_line("M\xe4rz"), "M" + r + "rz");
  EXPECT_EQ(one_line("a\xe9\x9a"), "a" + r + r);
  EXPECT_EQ(one_line("\xc0\xaf"), r + r);
  EXPECT_EQ(one_line("\xed\xa0\x80"), r + r + r);
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), r + r + r + r);
  EXPECT_EQ(valid_utf8("two\nlines\xff"), "two\nlines" + r);
}

// What would begin a new line of a log, set a terminal's title or turn the direction of writing.
TEST(Text, ControlCharactersBecomeSpaces) {
  EXPECT_EQ(one_line("a\nb\r\tc"), "a b  c");
  EXPECT_EQ(one_line("\x1b]0;title\x07"), " ]0;title ");
  EXPECT_EQ(one_line("\x7f\xc2\x9b"
                     "31m"),
            "  31m");
  EXPECT_EQ(one_line("a\xe2\x80\xa8"
                     "b\xe2\x80\xae"
                     "c\xe2\x81\xa6"
                     "d"),
            "a b c d");
  EXPECT_EQ(one_line(std::string("a\0b", 3)), "a b");
}

// Two texts that look alike would differ: zero width, word joiner, byte order mark, soft hyphen, a tag.
TEST(Text, CharactersOfNoWidthBecomeSpaces) {
  for (const char* unseen : {"\xe2\x80\x8b", "\xe2\x81\xa0", "\xef\xbb\xbf", "\xc2\xad", "\xf3\xa0\x81\x81"})
    EXPECT_EQ(one_line(std::string("a") + unseen + "b"), "a b");
}

TEST(Text, IsCutBetweenCharacters) {
  std::string umlauts;
  for (int i = 0; i < 31; ++i) umlauts += "\xc3\xbc";
  EXPECT_EQ(shorten(umlauts + umlauts.substr(0, 58)), umlauts + umlauts.substr(0, 58)) << "60 characters";
  EXPECT_EQ(shorten(umlauts + umlauts), umlauts + umlauts.substr(0, 52) + "...") << "62 characters";
}

// Of a line of a foreign file a message shows a word.
TEST(Text, ExcerptsOfFilesHaveFortyCharacters) {
  EXPECT_EQ(excerpt("x_m;y_m"), "`x_m;y_m`");
  EXPECT_EQ(excerpt(std::string(40, 'x')), "`" + std::string(40, 'x') + "`");
  EXPECT_EQ(excerpt(std::string(41, 'x')), "`" + std::string(37, 'x') + "...`");
}

TEST(Text, OfAFileMayBearAByteOrderMark) {
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbfx_m"), "x_m");
  EXPECT_EQ(without_byte_order_mark("x_m"), "x_m");
  EXPECT_TRUE(is_utf16(std::string("\xff\xfex\0", 4)));
  EXPECT_FALSE(is_utf16("x_m"));
}

}  // namespace
}  // namespace adit::protocol::text_test
