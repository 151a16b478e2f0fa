#include "ui/draw/fonts.h"

#include <hb-subset.h>
#include <hb.h>
#include <QColor>
#include <QFile>
#include <QFont>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QString>
#include <QtMath>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "ui/draw/font_choice.h"
#include "ui/draw/pixel_context.h"

/// This is outside of any namespace, as Qt requires. It registers the embedded files, which is
/// necessary in a static library.
static void initFontResources() {
  Q_INIT_RESOURCE(fonts);
}

namespace asperity {
namespace {

// Advances of DejaVu Sans 2.37 in units of 1/2048 of the font's size, U+0020 to U+007E.
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
// Latin-1, Greek, raised and lowered digits and letters, arrows and mathematical signs, in
// ascending order.
constexpr std::array<Special, 233> kSpecials = {
    {{0x00A0, 651, 713},   {0x00A1, 821, 934},   {0x00A2, 1303, 1425}, {0x00A3, 1303, 1425},
     {0x00A4, 1303, 1303}, {0x00A5, 1303, 1425}, {0x00A6, 690, 748},   {0x00A7, 1024, 1024},
     {0x00A8, 1024, 1024}, {0x00A9, 2048, 2048}, {0x00AA, 965, 1155},  {0x00AB, 1253, 1323},
     {0x00AC, 1716, 1716}, {0x00AD, 739, 850},   {0x00AE, 2048, 2048}, {0x00AF, 1024, 1024},
     {0x00B0, 1024, 1024}, {0x00B1, 1716, 1716}, {0x00B2, 821, 897},   {0x00B3, 821, 897},
     {0x00B4, 1024, 1024}, {0x00B5, 1303, 1507}, {0x00B6, 1303, 1303}, {0x00B7, 651, 778},
     {0x00B8, 1024, 1024}, {0x00B9, 821, 897},   {0x00BA, 965, 1155},  {0x00BB, 1253, 1323},
     {0x00BC, 1985, 2120}, {0x00BD, 1985, 2120}, {0x00BE, 1985, 2120}, {0x00BF, 1087, 1188},
     {0x00C0, 1401, 1585}, {0x00C1, 1401, 1585}, {0x00C2, 1401, 1585}, {0x00C3, 1401, 1585},
     {0x00C4, 1401, 1585}, {0x00C5, 1401, 1585}, {0x00C6, 1995, 2222}, {0x00C7, 1430, 1503},
     {0x00C8, 1294, 1399}, {0x00C9, 1294, 1399}, {0x00CA, 1294, 1399}, {0x00CB, 1294, 1399},
     {0x00CC, 604, 762},   {0x00CD, 604, 762},   {0x00CE, 604, 762},   {0x00CF, 604, 762},
     {0x00D0, 1587, 1716}, {0x00D1, 1532, 1714}, {0x00D2, 1612, 1741}, {0x00D3, 1612, 1741},
     {0x00D4, 1612, 1741}, {0x00D5, 1612, 1741}, {0x00D6, 1612, 1741}, {0x00D7, 1716, 1716},
     {0x00D8, 1612, 1741}, {0x00D9, 1499, 1663}, {0x00DA, 1499, 1663}, {0x00DB, 1499, 1663},
     {0x00DC, 1499, 1663}, {0x00DD, 1251, 1483}, {0x00DE, 1239, 1511}, {0x00DF, 1290, 1473},
     {0x00E0, 1255, 1382}, {0x00E1, 1255, 1382}, {0x00E2, 1255, 1382}, {0x00E3, 1255, 1382},
     {0x00E4, 1255, 1382}, {0x00E5, 1255, 1382}, {0x00E6, 2011, 2146}, {0x00E7, 1126, 1214},
     {0x00E8, 1260, 1389}, {0x00E9, 1260, 1389}, {0x00EA, 1260, 1389}, {0x00EB, 1260, 1389},
     {0x00EC, 569, 702},   {0x00ED, 569, 702},   {0x00EE, 569, 702},   {0x00EF, 569, 702},
     {0x00F0, 1253, 1407}, {0x00F1, 1298, 1458}, {0x00F2, 1253, 1407}, {0x00F3, 1253, 1407},
     {0x00F4, 1253, 1407}, {0x00F5, 1253, 1407}, {0x00F6, 1253, 1407}, {0x00F7, 1716, 1716},
     {0x00F8, 1253, 1407}, {0x00F9, 1298, 1458}, {0x00FA, 1298, 1458}, {0x00FB, 1298, 1458},
     {0x00FC, 1298, 1458}, {0x00FD, 1212, 1335}, {0x00FE, 1300, 1466}, {0x00FF, 1212, 1335},
     {0x02B0, 828, 933},   {0x0391, 1401, 1585}, {0x0392, 1405, 1561}, {0x0393, 1141, 1305},
     {0x0394, 1401, 1585}, {0x0395, 1294, 1399}, {0x0396, 1403, 1485}, {0x0397, 1540, 1714},
     {0x0398, 1612, 1741}, {0x0399, 604, 762},   {0x039A, 1343, 1587}, {0x039B, 1401, 1585},
     {0x039C, 1767, 2038}, {0x039D, 1532, 1714}, {0x039E, 1294, 1294}, {0x039F, 1612, 1741},
     {0x03A0, 1540, 1714}, {0x03A1, 1235, 1501}, {0x03A3, 1294, 1399}, {0x03A4, 1251, 1397},
     {0x03A5, 1251, 1483}, {0x03A6, 1612, 1741}, {0x03A7, 1403, 1579}, {0x03A8, 1612, 1740},
     {0x03A9, 1565, 1741}, {0x03AA, 604, 762},   {0x03AB, 1251, 1483}, {0x03AC, 1350, 1407},
     {0x03AD, 1107, 1140}, {0x03AE, 1298, 1458}, {0x03AF, 693, 798},   {0x03B0, 1185, 1383},
     {0x03B1, 1350, 1407}, {0x03B2, 1307, 1466}, {0x03B3, 1212, 1395}, {0x03B4, 1253, 1407},
     {0x03B5, 1107, 1140}, {0x03B6, 1114, 1210}, {0x03B7, 1298, 1458}, {0x03B8, 1253, 1407},
     {0x03B9, 693, 798},   {0x03BA, 1207, 1455}, {0x03BB, 1212, 1296}, {0x03BC, 1303, 1507},
     {0x03BD, 1144, 1395}, {0x03BE, 1142, 1210}, {0x03BF, 1253, 1407}, {0x03C0, 1233, 1620},
     {0x03C1, 1300, 1466}, {0x03C2, 1202, 1214}, {0x03C3, 1298, 1595}, {0x03C4, 1233, 1307},
     {0x03C5, 1185, 1383}, {0x03C6, 1351, 1602}, {0x03C7, 1183, 1321}, {0x03C8, 1351, 1626},
     {0x03C9, 1715, 1780}, {0x03D5, 1351, 1631}, {0x1D2E, 885, 983},   {0x1D34, 970, 1079},
     {0x1D49, 854, 981},   {0x2009, 409, 409},   {0x2013, 1024, 1024}, {0x2014, 2048, 2048},
     {0x2018, 651, 778},   {0x2019, 651, 778},   {0x201C, 1061, 1346}, {0x201D, 1061, 1346},
     {0x2026, 2048, 2048}, {0x202F, 409, 409},   {0x2032, 465, 540},   {0x2070, 821, 897},
     {0x2071, 366, 449},   {0x2074, 821, 897},   {0x2075, 821, 897},   {0x2076, 821, 897},
     {0x2077, 821, 897},   {0x2078, 821, 897},   {0x2079, 821, 897},   {0x207A, 1081, 1081},
     {0x207B, 1081, 1081}, {0x207C, 1081, 1081}, {0x207D, 503, 590},   {0x207E, 503, 590},
     {0x207F, 816, 933},   {0x2080, 821, 897},   {0x2081, 821, 897},   {0x2082, 821, 897},
     {0x2083, 821, 897},   {0x2084, 821, 897},   {0x2085, 821, 897},   {0x2086, 821, 897},
     {0x2087, 821, 897},   {0x2088, 821, 897},   {0x2089, 821, 897},   {0x208A, 1081, 1081},
     {0x208B, 1081, 1081}, {0x208C, 1081, 1081}, {0x208D, 503, 590},   {0x208E, 503, 590},
     {0x2090, 802, 937},   {0x2091, 854, 981},   {0x2092, 847, 999},   {0x2093, 909, 845},
     {0x2094, 854, 981},   {0x2095, 828, 933},   {0x2096, 872, 998},   {0x2097, 340, 449},
     {0x2098, 1276, 1359}, {0x2099, 816, 933},   {0x209A, 877, 981},   {0x209B, 764, 780},
     {0x209C, 604, 794},   {0x210E, 1298, 1458}, {0x2113, 846, 966},   {0x2190, 1716, 1716},
     {0x2191, 1716, 1716}, {0x2192, 1716, 1716}, {0x2193, 1716, 1716}, {0x2202, 1059, 1114},
     {0x2206, 1370, 1427}, {0x2207, 1370, 1427}, {0x2211, 1380, 1470}, {0x2212, 1716, 1716},
     {0x221A, 1305, 1366}, {0x221D, 1463, 1458}, {0x221E, 1706, 1706}, {0x222B, 1067, 1249},
     {0x2248, 1716, 1716}, {0x2260, 1716, 1716}, {0x2264, 1716, 1716}, {0x2265, 1716, 1716},
     {0x226A, 2144, 2144}, {0x226B, 2144, 2144}, {0x22C5, 651, 778},   {0x27E8, 799, 936},
     {0x27E9, 799, 936}}};
constexpr std::int16_t kUnknown = 2048;

}  // namespace

std::int16_t fontAdvance(std::uint32_t character, bool bold) {
  if (const auto& chosen = fontChoice().face(bold).advances; !chosen.empty())
    if (const auto found = chosen.find(character); found != chosen.end()) return found->second;
  if (character >= 0x20 && character < 0x7F)
    return bold ? kBold[character - 0x20] : kRegular[character - 0x20];
  const auto* const special = std::lower_bound(
      kSpecials.begin(), kSpecials.end(), character,
      [](const Special& entry, std::uint32_t wanted) { return entry.character < wanted; });
  if (special == kSpecials.end() || special->character != character) return kUnknown;
  return bold ? special->bold : special->regular;
}

namespace {

using Blob = std::unique_ptr<hb_blob_t, Destroyer<hb_blob_destroy>>;
using Face = std::unique_ptr<hb_face_t, Destroyer<hb_face_destroy>>;
using SubsetInput = std::unique_ptr<hb_subset_input_t, Destroyer<hb_subset_input_destroy>>;

Face makeFace(const QByteArray& file) {
  const Blob blob(hb_blob_create(file.constData(), static_cast<unsigned>(file.size()),
                                 HB_MEMORY_MODE_READONLY, nullptr, nullptr));
  return Face(hb_face_create(blob.get(), 0));
}

}  // namespace

QByteArray fontFile(bool bold) {
  initFontResources();
  QFile file(bold ? QStringLiteral(":/asperity/fonts/DejaVuSans-Bold.ttf")
                  : QStringLiteral(":/asperity/fonts/DejaVuSans.ttf"));
  if (!file.open(QIODevice::ReadOnly))
    throw std::runtime_error("The embedded font " + file.fileName().toStdString() +
                             " cannot be read.");
  return file.readAll();
}

std::set<char32_t> charactersIn(const DrawList& list, bool bold) {
  std::set<char32_t> characters;
  for (const DrawText& text : list.texts)
    if (text.bold == bold)
      for (const char32_t character : QString::fromStdString(text.utf8).toUcs4())
        characters.insert(character);
  return characters;
}

namespace {

QByteArray cutFont(const QByteArray& file, const std::set<char32_t>& characters) {
  const Face whole = makeFace(file);
  const SubsetInput input(hb_subset_input_create_or_fail());
  if (!input) throw std::runtime_error("There is no memory to cut a font.");
  hb_set_t* const wanted = hb_subset_input_unicode_set(input.get());
  for (const char32_t character : characters) hb_set_add(wanted, character);
  hb_set_t* const dropped = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
  for (const hb_tag_t table : {HB_TAG('G', 'S', 'U', 'B'), HB_TAG('G', 'P', 'O', 'S'),
                               HB_TAG('G', 'D', 'E', 'F'), HB_TAG('k', 'e', 'r', 'n')})
    hb_set_add(dropped, table);
  hb_subset_input_set_flags(input.get(), HB_SUBSET_FLAGS_NO_HINTING);
  const Face part(hb_subset_or_fail(whole.get(), input.get()));
  if (!part) throw std::runtime_error("A font cannot be cut to the glyphs in use.");
  const Blob bytes(hb_face_reference_blob(part.get()));
  unsigned size = 0;
  const char* const data = hb_blob_get_data(bytes.get(), &size);
  return {data, static_cast<qsizetype>(size)};
}

}  // namespace

QByteArray fontSubset(bool bold, const std::set<char32_t>& characters) {
  return cutFont(fontFile(bold), characters);
}

QByteArray chosenFontSubset(bool bold, const std::set<char32_t>& characters) {
  return cutFont(fontChoice().face(bold).file, characters);
}

namespace {

/// Returns the next character and moves `at` past it. In damaged UTF-8 each byte counts as a
/// character.
std::uint32_t nextCharacter(std::string_view utf8, std::size_t& at) {
  const auto byte = static_cast<unsigned char>(utf8[at++]);
  const int more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC0 ? 1 : 0;
  std::uint32_t character = more == 0 ? byte : byte & (0x3FU >> more);
  for (int i = 0; i < more && at < utf8.size() && (utf8[at] & 0xC0) == 0x80; ++i)
    character = (character << 6) | (static_cast<unsigned char>(utf8[at++]) & 0x3FU);
  return character;
}

}  // namespace

float textWidth(std::string_view utf8, float size, bool bold) {
  float units = 0;
  for (std::size_t at = 0; at < utf8.size();) units += fontAdvance(nextCharacter(utf8, at), bold);
  return units * size / kAdvancesPerSize;
}

float widestLine(const std::vector<std::string>& lines, float size) {
  float widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, textWidth(line, size));
  return widest;
}

float textScale(float pictureScale) {
  return pictureScale > 1 ? std::pow(pictureScale, 0.7F) : std::clamp(pictureScale, 0.85F, 1.0F);
}

float fittingSize(const std::string& utf8, float size, float least, bool bold, float width) {
  while (size - 1 >= least && textWidth(utf8, size, bold) > width) size -= 1;
  return size;
}

std::vector<std::string> wrapped(const std::string& utf8, float size, bool bold, float width) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < utf8.size();) {
    const std::size_t space = utf8.find_first_of(" \n", at);
    const std::size_t end = std::min(space, utf8.size());
    const std::string word = utf8.substr(at, end - at);
    const bool freshLine = lines.empty() || (at > 0 && utf8[at - 1] == '\n');
    if (freshLine)
      lines.push_back(word);
    else if (textWidth(lines.back() + " " + word, size, bold) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    at = end + 1;
  }
  for (std::string& line : lines) line = elided(line, size, bold, width);
  return lines;
}

std::string elided(const std::string& utf8, float size, bool bold, float width) {
  if (textWidth(utf8, size, bold) <= width) return utf8;
  const std::string ellipsis = "\u2026";
  const float available = width - textWidth(ellipsis, size, bold);
  std::size_t kept = 0;
  for (std::size_t at = 0; at < utf8.size();) {
    nextCharacter(utf8, at);
    if (textWidth(std::string_view(utf8).substr(0, at), size, bold) > available) break;
    kept = at;
  }
  while (kept > 0 && utf8[kept - 1] == ' ') --kept;
  return kept == 0 ? std::string() : utf8.substr(0, kept) + ellipsis;
}

namespace {

qreal leftEnd(const DrawText& text, qreal advance) {
  if (text.anchor == TextAnchor::Centre) return -advance / 2;
  return text.anchor == TextAnchor::Right ? -advance : 0;
}

void paintText(QPainter& painter, const DrawText& text) {
  const QFont font = toQFont(text);
  const QString words = QString::fromStdString(text.utf8);
  painter.save();
  painter.translate(text.x, text.y);
  if (text.angle != 0) painter.rotate(-qRadiansToDegrees(static_cast<qreal>(text.angle)));
  painter.setFont(font);
  painter.setPen(toQColor(text.colour));
  qreal left = leftEnd(text, QFontMetricsF(font).horizontalAdvance(words));
  if (text.angle == 0) left = std::round(text.x + left) - text.x;  // whole pixels give sharp stems
  painter.drawText(QPointF(left, 0), words);
  painter.restore();
}

}  // namespace

void loadFonts() {
  static const bool loaded = [] {
    for (const bool bold : {false, true})
      if (QFontDatabase::addApplicationFontFromData(fontFile(bold)) < 0)
        throw std::runtime_error("The embedded font DejaVu Sans cannot be loaded.");
    return true;
  }();
  static_cast<void>(loaded);
}

QColor toQColor(const Rgba& c) {
  return QColor::fromRgbF(c.r, c.g, c.b, c.a);
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](int from, int to) {
    return static_cast<int>(from + (to - from) * share + 0.5);
  };
  return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

QFont toQFont(const DrawText& text) {
  QFont font(QStringLiteral("DejaVu Sans"));
  if (const std::string& family = fontChoice().family; !family.empty())
    font.setFamilies({QString::fromStdString(family), QStringLiteral("DejaVu Sans")});
  font.setPixelSize(std::max(1, qRound(text.size)));
  font.setBold(text.bold);
  font.setKerning(false);  // as textWidth() measures
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

void paintTexts(QPainter& painter, const DrawList& list) {
  painter.save();
  painter.setRenderHint(QPainter::TextAntialiasing);
  for (const DrawText& text : list.texts) paintText(painter, text);
  painter.restore();
}

QImage renderImage(PixelContext& context, const DrawList& list) {
  // The image takes over the pixels instead of copying them.
  auto* pixels = new Pixels(context.draw(list));
  QImage image(
      pixels->rgba.data(), pixels->width, pixels->height, qsizetype{4} * pixels->width,
      QImage::Format_RGBA8888_Premultiplied, [](void* p) { delete static_cast<Pixels*>(p); },
      pixels);
  QPainter painter(&image);
  paintTexts(painter, list);
  painter.end();
  return image;
}

}  // namespace asperity
