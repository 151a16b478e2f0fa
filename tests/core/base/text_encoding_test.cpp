#include "core/base/text_encoding.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

using namespace std::string_literals;

/// Latin text as two bytes a letter.
std::string utf16(const std::string& text, bool littleEndian) {
  std::string bytes;
  for (const char letter : text)
    bytes += littleEndian ? std::string{letter, '\0'} : std::string{'\0', letter};
  return bytes;
}

TEST(DetectNonText, TextInUtf8IsNotForeign) {
  for (const char* text : {"", "{}", "x,z\n0,1\n", "\xEF\xBB\xBF{}", "Größe", "RI", "\xE4"})
    EXPECT_EQ(detectNonText(text), "") << text;
}

TEST(DetectNonText, Utf16IsKnownWithItsMarkAndWithout) {
  const std::string text = "x (mm)\tz (mm)\r\n0\t1\r\n";
  for (const bool littleEndian : {true, false}) {
    EXPECT_EQ(detectNonText(utf16(text, littleEndian)), "text in UTF-16");
    EXPECT_EQ(detectNonText(utf16("{}", littleEndian)), "text in UTF-16");
  }
  EXPECT_EQ(detectNonText("\xFF\xFE" + utf16(text, true)), "text in UTF-16");
  EXPECT_EQ(detectNonText("\xFE\xFF" + utf16(text, false)), "text in UTF-16");
  EXPECT_EQ(detectNonText("\xFF\xFE\0\0x\0\0\0"s), "text in UTF-32");
}

TEST(DetectNonText, OtherFilesAreNamed) {
  EXPECT_EQ(detectNonText("\x89PNG\r\n"), "a PNG picture");
  EXPECT_EQ(detectNonText("PK\3\4"), "a ZIP archive (as of a spreadsheet)");
  EXPECT_EQ(detectNonText("%PDF-1.7"), "a PDF document");
  EXPECT_EQ(detectNonText("ISO-1.0\0\1\2\3\4\5\6\7\x08\x09 and more"s), "a binary file");
}

TEST(DetectNonText, ZerosBehindATextAreNoneOfIt) {
  EXPECT_EQ(detectNonText("x,z\n0,1\n1,2\n\0\0\0"s), "");
  EXPECT_EQ(detectNonText("x,z\n0,1\n1,2\n\0\0\0x"s), "a binary file");
}

TEST(IsUtf8, OnlyTheShortestEncodingOfACharacterIs) {
  for (const char* text : {"", "ASCII alone, long", "Größe", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
    EXPECT_TRUE(isUtf8(text)) << text;
  for (const char* text : {"\xC0\x80", "\xE0\x80\x80", "\xF0\x80\x80\x80",  // longer than needed
                           "\xED\xA0\x80",                                  // a surrogate
                           "\xF4\x90\x80\x80",  // beyond the last character of Unicode
                           "eight..\xE4", "\x80"})
    EXPECT_FALSE(isUtf8(text)) << text;
}

/// Japanese instruments write Shift-JIS, of which Latin-1 made words of no language.
TEST(DecodedText, ShiftJisIsKnownByItsWords) {
  const std::string bytes =
      "\x89\xB7\x93\x78"
      "(\x81\x8E"
      "),\x8E\xFC\x94\x67\x90\x94"
      "(Hz),tan\x83\xC2\n20,1,0.1\n";
  const DecodedText decoded(bytes, "mine.csv");
  EXPECT_EQ(decoded.encoding, "Shift-JIS");
  EXPECT_EQ(decoded.text, "\u6E29\u5EA6(\u2103),\u5468\u6CE2\u6570(Hz),tan\u03B4\n20,1,0.1\n");
  // Letters of Latin-1 may be those of Shift-JIS, too.
  const std::string latin =
      "Ger\xE4t;Pr\xFC"
      "fung\n1;2\n";
  EXPECT_EQ(DecodedText(latin, "mine.csv").encoding, "Latin-1");
  // A file that is cut off within a character is none.
  EXPECT_EQ(DecodedText("\x89\xB7\x93\x78\x89", "mine.csv").encoding, "Latin-1");
}

TEST(DecodedText, CodePagesAreKnownByTheirWords) {
  const auto encoding = [](const std::string& bytes) {
    return std::string(DecodedText(bytes + ";mu\n1;2\n", "mine.csv").encoding);
  };
  // Words for friction, temperature, velocity and modulus.
  EXPECT_EQ(encoding("\xD1\xEA\xEE\xF0\xEE\xF1\xF2\xFC"), "Windows-1251");
  EXPECT_EQ(encoding("H\xFDz (mm/s)"), "Windows-1254");
  EXPECT_EQ(encoding("Sou\xE8initel t\xF8"
                     "en\xED"),
            "Windows-1250");
  EXPECT_EQ(encoding("\xC4\xA6\xB2\xC1\xCF\xB5\xCA\xFD"), "GBK");
  EXPECT_EQ(encoding("\xB8\xB6\xC2\xFB\xB0\xE8\xBC\xF6"), "EUC-KR");
  EXPECT_EQ(encoding("Pr\xFC"
                     "fung \xE9t\xE9 \xC5\xE4\xF6"),
            "Latin-1");
  EXPECT_EQ(DecodedText("\xD1\xEA\xEE\xF0\xEE\xF1\xF2\xFC", "mine.csv").text,
            "\u0421\u043A\u043E\u0440\u043E\u0441\u0442\u044C");
}

TEST(DecodedText, UndoesASecondEncoding) {
  const auto text = [](const std::string& bytes) {
    return std::string(DecodedText(bytes, "mine.csv").text);
  };
  EXPECT_EQ(text("T (\u00C2\u00B0C);z (\u00C2\u00B5m);H\u00C3\u00B6he\n"),
            "T (\u00B0C);z (\u00B5m);H\u00F6he\n");
  for (const char* once : {"Profondit\u00C3 \u00B0C\n", "\u00C2ge (\u00B5m)\n", "T (\u00B0C)\n"})
    EXPECT_EQ(text(once), once);
}

}  // namespace
}  // namespace asperity
