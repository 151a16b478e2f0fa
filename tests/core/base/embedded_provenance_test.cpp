// The text that stands in a file, and not what looks like it.
#include "core/base/embedded_provenance.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace asperity {
namespace {

using std::literals::operator""s;

const std::string kFalse = R"({"schema":"asperity-false/1","scene":{}})";
const std::string kTrue = R"({"schema":"asperity-true/1"})";

std::string bigEndian(std::size_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(data.size()) + type + data + "_crc";
}

std::string png(const std::string& chunks) {
  return "\x89PNG\r\n\x1A\n" + chunk("IHDR", std::string(13, '\0')) + chunks;
}

std::string text(const std::string& key, const std::string& value) {
  return chunk("iTXt", key + "\0\0\0\0\0"s + value);
}

TEST(EmbeddedProvenance, OfAPngIsThatOfItsKey) {
  const std::string end = chunk("IDAT", "pixels") + chunk("IEND", "");
  EXPECT_EQ(embeddedProvenance(png(text("asperity", kTrue) + end)), kTrue);
  for (const std::string& title : {kFalse, text("asperity", kFalse), "asperity" + kFalse})
    EXPECT_EQ(embeddedProvenance(png(text("Title", title) + text("asperity", kTrue) + end)), kTrue);
  EXPECT_EQ(embeddedProvenance(png(text("Title", kFalse) + end)), "");
  EXPECT_EQ(embeddedProvenance(png(end + text("asperity", kFalse))), "");  // after the picture
  const std::string whole = png(text("asperity", kTrue) + end);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string found = embeddedProvenance(std::string_view(whole).substr(0, size));
    EXPECT_TRUE(found.empty() || found == kTrue) << size;
  }
  EXPECT_EQ(embeddedProvenance("\x89PNG\r\n\x1A\n" + std::string(12, '\xFF') + kFalse), "");
}

TEST(EmbeddedProvenance, OfAnSvgIsItsMetadata) {
  EXPECT_EQ(embeddedProvenance(
                "<svg><title>{&quot;schema&quot;:&quot;asperity-x</title><metadata>{&quot;a&quot;:"
                "&#34;1 &lt; 2 &amp;amp; &gt;&#x22;}</metadata>"),
            R"({"a":"1 < 2 &amp; >"})");
  EXPECT_EQ(embeddedProvenance("\xEF\xBB\xBF\n<svg>\n<metadata id=\"m\">\n{} </metadata>"),
            "\n{} ");
  EXPECT_EQ(embeddedProvenance("<svg><title>" + kFalse + "</title></svg>"), "");
  EXPECT_EQ(embeddedProvenance("<svg><metadata>" + kFalse), "");  // cut off
}

TEST(EmbeddedProvenance, OfAPacketIsItsDescription) {
  const std::string packet =
      "<dc:title><rdf:Alt><rdf:li "
      "xml:lang=\"x-default\">{&quot;false&quot;}</rdf:li></rdf:Alt></dc:title>"
      "<dc:description><rdf:Alt><rdf:li xml:lang=\"x-default\">{&quot;true&quot;}</rdf:li>";
  for (const std::string beginning : {"%PDF-1.4\n", "GIF89a", "RIFF____WEBP"})
    EXPECT_EQ(embeddedProvenance(beginning + kFalse + packet), "{\"true\"}") << beginning;
}

TEST(EmbeddedProvenance, OfAnMp4IsItsComment) {
  const auto box = [](const std::string& value) {
    const std::string data = bigEndian(value.size() + 16) + "data\0\0\0\1\0\0\0\0"s + value;
    return bigEndian(data.size() + 8) +
           "\xA9"
           "cmt" +
           data;
  };
  const std::string film =
      "\0\0\0\x20"
      "ftypisom"s;
  EXPECT_EQ(embeddedProvenance(film + kFalse +
                               "\xC2\xA9"
                               "cmt____data" +
                               kFalse + box(kTrue) + "more"),
            kTrue);
  EXPECT_EQ(embeddedProvenance(film +
                               "\xA9"
                               "cmt\xFF\xFF\xFF\xFF"
                               "data\0\0\0\1\0\0\0\0"s +
                               kFalse),
            "");
}

TEST(EmbeddedProvenance, OfAWebmIsItsComment) {
  const std::string tag = "\x1A\x45\xDF\xA3" + kFalse +
                          "\x45\xA3\x87"
                          "COMMENT"
                          "\x44\x87";
  EXPECT_EQ(embeddedProvenance(tag + static_cast<char>(0x80U | kTrue.size()) + kTrue + "more"),
            kTrue);
  const std::string wide = tag + '\x01' + std::string(6, '\0') + static_cast<char>(kTrue.size());
  EXPECT_EQ(embeddedProvenance(wide + kTrue + "more"), kTrue);
  EXPECT_EQ(embeddedProvenance(tag + "\xFE" + kTrue), "");  // says that it is longer
  EXPECT_EQ(embeddedProvenance(tag + std::string(1, '\0')), "");
  EXPECT_EQ(embeddedProvenance(tag), "");
}

TEST(EmbeddedProvenance, OfATableIsItsFirstLine) {
  EXPECT_EQ(embeddedProvenance("# asperity: " + kTrue + "\r\nvelocity,mu\n"), kTrue);
  EXPECT_EQ(embeddedProvenance("velocity,mu\n# asperity: " + kFalse + "\n"), "");
  EXPECT_EQ(embeddedProvenance(kFalse), "");
  EXPECT_EQ(embeddedProvenance(""), "");
}

}  // namespace
}  // namespace asperity
