#include "ui/draw/font_choice.h"

#include <fontconfig/fontconfig.h>
#include <QFile>
#include <QString>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/destroyer.h"
#include "core/base/input_error.h"
#include "core/base/text.h"

namespace asperity {
namespace {

constexpr const char* kOption = "--font";

using Pattern = std::unique_ptr<FcPattern, Destroyer<FcPatternDestroy>>;
using Objects = std::unique_ptr<FcObjectSet, Destroyer<FcObjectSetDestroy>>;
using Fonts = std::unique_ptr<FcFontSet, Destroyer<FcFontSetDestroy>>;

FontChoice& present() {
  static FontChoice choice;
  return choice;
}

std::string patternText(const FcPattern* pattern, const char* object) {
  FcChar8* text = nullptr;
  if (FcPatternGetString(pattern, object, 0, &text) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(text);
}

int patternNumber(const FcPattern* pattern, const char* object) {
  int number = 0;
  FcPatternGetInteger(pattern, object, 0, &number);
  return number;
}

/// Returns the installed outline fonts whose tables a vector file can contain.
Fonts installedFonts() {
  const Pattern all(FcPatternCreate());
  FcPatternAddBool(all.get(), FC_OUTLINE, FcTrue);
  const Objects objects(FcObjectSetBuild(FC_FAMILY, FC_FILE, FC_INDEX, FC_WEIGHT, FC_SLANT,
                                         FC_WIDTH, FC_FONTFORMAT, static_cast<char*>(nullptr)));
  return Fonts(FcFontList(nullptr, all.get(), objects.get()));
}

/// Returns the distance of a font from the upright one of normal width.
int distance(const FcPattern* font, bool bold) {
  const int weight = bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR;
  return std::abs(patternNumber(font, FC_WEIGHT) - weight) + 10 * patternNumber(font, FC_SLANT) +
         10 * std::abs(patternNumber(font, FC_WIDTH) - FC_WIDTH_NORMAL);
}

bool isSame(const std::string& one, const std::string& other) {
  return QString::fromStdString(one).compare(QString::fromStdString(other), Qt::CaseInsensitive) ==
         0;
}

/// Reads a font and measures every character that it has.
FontChoice::Face readFace(const FcPattern* font, const std::string& family) {
  FontChoice::Face face;
  QFile file(QString::fromStdString(patternText(font, FC_FILE)));
  if (!file.open(QIODevice::ReadOnly))
    throw InputError("", kOption,
                     message("{}: its file {} cannot be read", family, patternText(font, FC_FILE)));
  const QByteArray bytes = file.readAll();
  face.advances =
      measuredAdvances(bytes, static_cast<unsigned>(patternNumber(font, FC_INDEX) & 0xFFFF));
  if (face.advances.empty())
    throw InputError("", kOption, message("{} has no characters that can be measured", family));
  if (bytes.startsWith("ttcf"))
    throw InputError("", kOption,
                     message("{} is in a collection of fonts (.ttc), of which a picture cannot "
                             "contain a part",
                             family));
  face.file = bytes;
  return face;
}

}  // namespace

const FontChoice& fontChoice() {
  return present();
}

void useFontFamily(const std::string& family) {
  if (family == present().family) return;
  if (family.empty() || isSame(family, "DejaVu Sans")) {
    present() = {};
    return;
  }
  const Fonts fonts = installedFonts();
  std::vector<const FcPattern*> members;
  std::vector<std::string> names;
  for (int i = 0; fonts && i < fonts->nfont; ++i) {
    const FcPattern* font = fonts->fonts[i];
    const std::string format = patternText(font, FC_FONTFORMAT);
    if (format != "TrueType" && format != "CFF") continue;
    names.push_back(patternText(font, FC_FAMILY));
    if (isSame(names.back(), family)) members.push_back(font);
  }
  if (members.empty()) {
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string nearest(nearestWord(family, known));
    throw InputError(
        "", kOption,
        nearest.empty() ? message("no font family '{}' is installed; 'fc-list : family' lists them",
                                  shortened(family))
                        : message("no font family '{}' is installed; did you mean '{}'?",
                                  shortened(family), nearest));
  }
  FontChoice choice;
  choice.family = patternText(members.front(), FC_FAMILY);
  for (const bool bold : {false, true}) {
    const FcPattern* font = *std::ranges::min_element(
        members, {}, [bold](const FcPattern* one) { return distance(one, bold); });
    choice.faces[bold ? 1 : 0] = readFace(font, choice.family);
  }
  present() = std::move(choice);
}

}  // namespace asperity
