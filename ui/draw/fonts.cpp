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

#include "core/base/destroyer.h"
#include "ui/draw/font_choice.h"
#include "ui/draw/pixel_context.h"

/// This is outside of any namespace, as Qt requires. It registers the embedded files, which is
/// necessary in a static library.
static void initFontResources() {
  Q_INIT_RESOURCE(fonts);
}

namespace asperity {
namespace {

constexpr std::int16_t kUnknown = 2048;

using Blob = std::unique_ptr<hb_blob_t, Destroyer<hb_blob_destroy>>;
using Face = std::unique_ptr<hb_face_t, Destroyer<hb_face_destroy>>;
using Font = std::unique_ptr<hb_font_t, Destroyer<hb_font_destroy>>;
using Characters = std::unique_ptr<hb_set_t, Destroyer<hb_set_destroy>>;
using SubsetInput = std::unique_ptr<hb_subset_input_t, Destroyer<hb_subset_input_destroy>>;

Face makeFace(const QByteArray& file, unsigned index = 0) {
  const Blob blob(hb_blob_create(file.constData(), static_cast<unsigned>(file.size()),
                                 HB_MEMORY_MODE_READONLY, nullptr, nullptr));
  return Face(hb_face_create(blob.get(), index));
}

}  // namespace

FontAdvances measuredAdvances(const QByteArray& file, unsigned index) {
  FontAdvances advances;
  const Face face = makeFace(file, index);
  const unsigned unitsPerSize = hb_face_get_upem(face.get());
  const Characters characters(hb_set_create());
  hb_face_collect_unicodes(face.get(), characters.get());
  const Font font(hb_font_create(face.get()));
  for (hb_codepoint_t character = HB_SET_VALUE_INVALID;
       hb_set_next(characters.get(), &character);) {
    hb_codepoint_t glyph = 0;
    if (!hb_font_get_nominal_glyph(font.get(), character, &glyph)) continue;
    const double advance = hb_font_get_glyph_h_advance(font.get(), glyph);
    const double units = advance * static_cast<double>(kAdvancesPerSize) / unitsPerSize;
    advances[character] = static_cast<std::int16_t>(std::clamp(units, 0.0, 32767.0) + 0.5);
  }
  return advances;
}

std::int16_t fontAdvance(std::uint32_t character, bool bold) {
  static const std::array<FontAdvances, 2> embedded{measuredAdvances(fontFile(false)),
                                                    measuredAdvances(fontFile(true))};
  for (const FontAdvances* advances : {&fontChoice().face(bold).advances, &embedded[bold ? 1 : 0]})
    if (const auto found = advances->find(character); found != advances->end())
      return found->second;
  return kUnknown;
}

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
  hb_set_t* const kept = hb_subset_input_unicode_set(input.get());
  for (const char32_t character : characters) hb_set_add(kept, character);
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
