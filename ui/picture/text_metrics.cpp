#include "ui/picture/text_metrics.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace asperity {
namespace {

// Advances of DejaVu Sans 2.37 in units of 1/2048 of the font's size, U+0020 to U+007E.
constexpr float kUnitsPerSize = 2048;
constexpr std::array<std::int16_t, 95> kRegular = {
    651,  821,  942,  1716, 1303, 1946, 1597, 563,  799,  799,  1024, 1716, 651,  739,  651,  690,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690,  690,  1716, 1716, 1716, 1087,
    2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604,  604,  1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799,  690,  799,  1716, 1024,
    1024, 1255, 1300, 1126, 1300, 1260, 721,  1300, 1298, 569,  569,  1186, 569,  1995, 1298, 1253,
    1300, 1300, 842,  1067, 803,  1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,  1303, 1716};
constexpr std::array<std::int16_t, 95> kBold = {
    713,  934,  1067, 1716, 1425, 2052, 1786, 627,  936,  936,  1071, 1716, 778,  850,  778,  748,
    1425, 1425, 1425, 1425, 1425, 1425, 1425, 1425, 1425, 1425, 819,  819,  1716, 1716, 1716, 1188,
    2048, 1585, 1561, 1503, 1700, 1399, 1399, 1681, 1714, 762,  762,  1587, 1305, 2038, 1714, 1741,
    1501, 1741, 1577, 1475, 1397, 1663, 1585, 2259, 1579, 1483, 1485, 936,  748,  936,  1716, 1024,
    1024, 1382, 1466, 1214, 1466, 1389, 891,  1466, 1458, 702,  702,  1362, 702,  2134, 1458, 1407,
    1466, 1466, 1010, 1219, 979,  1458, 1335, 1892, 1321, 1335, 1192, 1458, 748,  1458, 1716};

struct Special {
  std::uint32_t character;
  std::int16_t regular, bold;
};
constexpr Special kSpecials[] = {
    {0x00B0, 1024, 1024}, {0x00B2, 821, 897},   {0x00B3, 821, 897},   {0x00B5, 1303, 1507},
    {0x00B7, 651, 778},   {0x00B9, 821, 897},   {0x00D7, 1716, 1716}, {0x03B7, 1298, 1458},
    {0x03BC, 1303, 1507}, {0x03C4, 1233, 1307}, {0x2013, 1024, 1024}, {0x2026, 2048, 2048},
    {0x2070, 821, 897},   {0x2074, 821, 897},   {0x2075, 821, 897},   {0x2076, 821, 897},
    {0x2077, 821, 897},   {0x2078, 821, 897},   {0x2079, 821, 897},   {0x207B, 1081, 1081},
    {0x2190, 1716, 1716}, {0x2192, 1716, 1716}, {0x2212, 1716, 1716}, {0x2248, 1716, 1716},
};
constexpr std::int16_t kUnknown = 2048;

/// The next character; advances `at` past it. Damaged UTF-8 counts one character a byte.
std::uint32_t nextCharacter(std::string_view utf8, std::size_t& at) {
  const auto byte = static_cast<unsigned char>(utf8[at++]);
  const int more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC0 ? 1 : 0;
  std::uint32_t character = more == 0 ? byte : byte & (0x3FU >> more);
  for (int i = 0; i < more && at < utf8.size() && (utf8[at] & 0xC0) == 0x80; ++i)
    character = (character << 6) | (static_cast<unsigned char>(utf8[at++]) & 0x3FU);
  return character;
}

std::int16_t advance(std::uint32_t character, bool bold) {
  if (character >= 0x20 && character < 0x7F)
    return bold ? kBold[character - 0x20] : kRegular[character - 0x20];
  for (const Special& special : kSpecials)
    if (special.character == character) return bold ? special.bold : special.regular;
  return kUnknown;
}

}  // namespace

float textWidth(std::string_view utf8, float size, bool bold) {
  float units = 0;
  for (std::size_t at = 0; at < utf8.size();) units += advance(nextCharacter(utf8, at), bold);
  return units * size / kUnitsPerSize;
}

std::string elided(const std::string& utf8, float size, bool bold, float width) {
  if (textWidth(utf8, size, bold) <= width) return utf8;
  const std::string ellipsis = "\u2026";
  const float room = width - textWidth(ellipsis, size, bold);
  std::size_t kept = 0;
  for (std::size_t at = 0; at < utf8.size();) {
    nextCharacter(utf8, at);
    if (textWidth(std::string_view(utf8).substr(0, at), size, bold) > room) break;
    kept = at;
  }
  while (kept > 0 && utf8[kept - 1] == ' ') --kept;
  return kept == 0 ? std::string() : utf8.substr(0, kept) + ellipsis;
}

}  // namespace asperity
