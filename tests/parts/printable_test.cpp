// What tools print of names and strings that come from outside.
#include "tools/common/json.h"
#include "tools/common/print.h"

#include <gtest/gtest.h>
#include <string>

namespace masu {
namespace {

TEST(Printable, KeepsTextAsItIs) {
  for (const char* text : {"", "a b.scene", "升/マス", "é", "\xf0\x9f\x98\x80", "a\\b"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a\nb"), "a\\x0ab");
  EXPECT_EQ(printable("\x1b[2J"), "\\x1b[2J");
  EXPECT_EQ(printable("\x7f"), "\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");          // U+009B, CSI
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae"); // U+202E, from right to left
  EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
}

TEST(Grouped, HasACommaBeforeEveryThreeDigits) {
  for (const auto& [number, text] : std::initializer_list<std::pair<std::uint64_t, const char*>>{
           {0, "0"},
           {999, "999"},
           {1000, "1,000"},
           {123456, "123,456"},
           {1234567, "1,234,567"},
           {~std::uint64_t{0}, "18,446,744,073,709,551,615"}})
    EXPECT_EQ(grouped(number), text);
}

TEST(Printable, EscapesNoncharacters) {
  EXPECT_EQ(printable("\xef\xbf\xbf"), "\\xef\\xbf\\xbf");          // U+FFFF
  EXPECT_EQ(printable("\xef\xb7\x90"), "\\xef\\xb7\\x90");          // U+FDD0
  EXPECT_EQ(printable("\xf0\x9f\xbf\xbe"), "\\xf0\\x9f\\xbf\\xbe"); // U+1FFFE
  EXPECT_EQ(printable("\xef\xbf\xbd"), "\xef\xbf\xbd");             // U+FFFD, which is one
}

TEST(Printable, EscapesInvalidUtf8) {
  EXPECT_EQ(printable("a\xff"), "a\\xff");
  EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80");                   // too long
  EXPECT_EQ(printable("\xe0\x80\x80"), "\\xe0\\x80\\x80");          // too long
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");          // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80"); // beyond U+10FFFF
  EXPECT_EQ(printable("\xe5\x8d"), "\\xe5\\x8d");                   // cut off
}

// Every sequence of up to three bytes: what is left has no control character, and is valid UTF-8.
TEST(Printable, LeavesNoControlCharacter) {
  for (std::uint32_t bytes = 0; bytes < 1U << 24; bytes += bytes < 1U << 16 ? 1 : 7) {
    std::string text;
    for (std::uint32_t rest = bytes; rest != 0; rest >>= 8)
      text += static_cast<char>(rest & 0xff);
    const std::string line = printable(text);
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto c = static_cast<unsigned char>(line[i]);
      ASSERT_TRUE(c >= 0x20 && c != 0x7f);
      ASSERT_FALSE(c == 0xc2 && static_cast<unsigned char>(line[i + 1]) < 0xa0);
    }
    ASSERT_NO_THROW(nlohmann::json(line).dump());
  }
}

TEST(Printable, JsonOfAnyBytesIsValid) {
  const nlohmann::ordered_json json{{"name", "a\xff\x1b[2J\x7f\xc2\x9b升"}};
  const std::string text = json_text(json, -1);
  EXPECT_EQ(text, R"({"name":"a)"
                  "\xef\xbf\xbd"
                  R"(\u001b[2J\u007f\u009b升"})");
  EXPECT_EQ(nlohmann::json::parse(text)["name"], "a\xef\xbf\xbd\x1b[2J\x7f\xc2\x9b升");
}

} // namespace
} // namespace masu
