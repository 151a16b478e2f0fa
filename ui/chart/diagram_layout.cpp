#include "ui/chart/diagram_layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_number.h"
#include "ui/chart/diagram_axes.h"

namespace asperity {
namespace {

constexpr float kLineHeight = 1.35F;  // in sizes of the font
constexpr std::string_view kHardBlank = "\u00A0";

struct Paragraph {
  std::vector<std::string> lines;
  float size = 12;
  float height() const { return static_cast<float>(lines.size()) * kLineHeight * size; }
};

/// Returns whether a line may end at this blank: after a mark, or between two words. "G = 10 MPa"
/// and "Eq. (11)" stay together.
bool mayBreakAt(const std::string& text, std::size_t blank) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::size_t next = blank + 1;
  if (blank < 2 || next + 1 >= text.size()) return false;
  const char last = text[blank - 1];
  if (last == ',' || last == ';') return true;
  const bool beginsWord = isLetter(text[next]) && isLetter(text[next + 1]);
  if (last == '.' || last == ':') return beginsWord;
  return beginsWord && isLetter(last) && isLetter(text[blank - 2]);
}

std::string withHardBlanks(const std::string& text) {
  std::string joined;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == ' ' && !mayBreakAt(text, i))
      joined += kHardBlank;
    else
      joined += text[i];
  return joined;
}

bool isCut(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.empty() || line.ends_with("…"); });
}

/// Shortens a last line that is not the end of a text: whole words and an ellipsis.
std::string cutOff(std::string line, float size, bool bold, float width) {
  while (textWidth(line + " …", size, bold) > width && line.rfind(' ') != line.npos)
    line.erase(line.rfind(' '));
  return elided(line.ends_with("…") ? line : line + " …", size, bold, width);
}

/// Breaks a text into at most `most` lines, in the largest size down to `least` that allows it.
Paragraph paragraph(const std::string& text, float size, float least, bool bold, float width,
                    std::size_t most) {
  Paragraph p{{}, size};
  if (text.empty() || most < 1) return p;
  for (;; p.size -= 1) {
    for (const std::string& words : {withHardBlanks(text), text}) {
      p.lines = wrapped(words, p.size, bold, width);
      if (p.lines.size() <= most && !isCut(p.lines)) break;
    }
    if ((p.lines.size() <= most && !isCut(p.lines)) || p.size - 1 < least) break;
  }
  for (std::string& line : p.lines) replaceAll(line, kHardBlank, " ");
  if (p.lines.size() > most) {
    p.lines.resize(most);
    p.lines.back() = cutOff(p.lines.back(), p.size, bold, width);
  }
  std::erase(p.lines, "");
  return p;
}

/// Returns the text without its last sentence; empty for one sentence. "Eq. (11)" and "z. B." end
/// none.
std::string withoutLastSentence(const std::string& text) {
  constexpr std::size_t kShortestWord = 3;
  for (std::size_t at = text.rfind(". "); at != text.npos && at > 0;
       at = text.rfind(". ", at - 1)) {
    const std::size_t word = at - std::min(at, text.rfind(' ', at) + 1);
    const char next = at + 2 < text.size() ? text[at + 2] : ' ';
    if (word >= kShortestWord && next >= 'A' && next <= 'Z') return text.substr(0, at + 1);
  }
  return {};
}

void addParagraph(DrawList& list, const Paragraph& p, DrawPoint at, bool bold, const Rgba& colour) {
  for (const std::string& line : p.lines) {
    addText(list, {{line, bold}}, {at.x, std::round(at.y + p.size)}, p.size, colour);
    at.y += kLineHeight * p.size;
  }
}

float fontSize(float size) {
  return std::max(kSmallestFont, std::round(size));
}

std::size_t linesIn(float height, float size, std::size_t most) {
  return std::min(most, static_cast<std::size_t>(std::max(0.0F, height / (kLineHeight * size))));
}

}  // namespace

SheetGrid gridFor(const DiagramSheet& sheet) {
  const int count =
      std::max(1, static_cast<int>(std::min<std::size_t>(sheet.diagrams.size(), 100)));
  if (count <= 3 && sheet.columns <= 0) return {count, 1};
  const int columns = sheet.columns > 0 ? std::min(sheet.columns, count)
                                        : static_cast<int>(std::ceil(std::sqrt(count)));
  return {columns, (count + columns - 1) / columns};
}

bool hasCommonAxis(const DiagramSheet& sheet) {
  return sheet.sharesAxis && gridFor(sheet).columns == 1;
}

bool hasStrips(const DiagramSheet& sheet) {
  return hasCommonAxis(sheet) && sheet.diagrams.size() >= 3;
}

namespace {

/// Returns the sizes around letters of a given size.
DiagramSizes sizesAround(const DiagramFormat& format) {
  const float letters = format.fontSize;
  const auto font = [&](float size) {
    return fontSize(std::max(format.minFontSize, size * letters));
  };
  DiagramSizes sizes{letters / 12.5F, font(1.25F), font(1), font(1.1F),
                     font(1.1F),      font(1),     font(1), font(0.92F)};
  sizes.minFontSize = std::max(sizes.minFontSize, std::floor(format.minFontSize));
  return sizes;
}

DiagramSizes automaticSizes(const DiagramSheet& sheet, const DiagramOptions& options) {
  if (options.above && options.above->unit > 0) {
    const float unit = options.above->unit, letters = fontSize(12 * unit);
    return {unit,   fontSize(19 * unit), letters, fontSize(14 * unit), letters, letters, letters,
            letters};
  }
  const float scale = options.scale > 0 ? options.scale : 1;
  const SheetGrid grid = gridFor(sheet);
  const float width = static_cast<float>(options.width) / static_cast<float>(grid.columns);
  const float height = static_cast<float>(options.height) / static_cast<float>(grid.rows);
  const float available = std::min(width / (900 * scale), height / (620 * scale));
  float unit = scale * textScale(available);
  unit = std::max(std::min({unit, width / 350, height / 380}), options.minTextSize * scale);
  return {unit,
          fontSize(19 * unit),
          fontSize(13 * unit),
          fontSize(14 * unit),
          fontSize(14 * unit),
          fontSize(12.5F * unit),
          fontSize(12.5F * unit),
          fontSize(11.5F * unit)};
}

}  // namespace

DiagramSizes sizesFor(const DiagramSheet& sheet, const DiagramOptions& options) {
  DiagramSizes sizes =
      options.format.fontSize > 0 ? sizesAround(options.format) : automaticSizes(sheet, options);
  sizes.curve = options.format.lineWidth;
  sizes.legendMode = options.format.legend;
  sizes.ticks = options.format.ticks;
  // On a screen ticks are outside, as those of the contact and of the chart in the window.
  if (sizes.ticks == TickSide::Automatic)
    sizes.ticks = options.above || !options.theme.isForPrint ? TickSide::Outside : TickSide::Inside;
  sizes.isPrinted = options.format.fontSize > 0;
  return sizes;
}

float sheetMargin(const DiagramSizes& sizes) {
  return std::round(18 * sizes.unit);
}

std::vector<Box> cellsFor(const DiagramSheet& sheet, const DiagramOptions& options, float top,
                          float bottom, const DiagramSizes& sizes, float between) {
  const SheetGrid grid = gridFor(sheet);
  const float side = sheetMargin(sizes), gap = std::round(between * sizes.unit);
  const auto columns = static_cast<float>(grid.columns), rows = static_cast<float>(grid.rows);
  const float width =
      (static_cast<float>(options.width) - 2 * side - (columns - 1) * gap) / columns;
  // A common x-axis has its labels only under the lowest frame.
  const float under = hasCommonAxis(sheet) ? belowAxes(sizes) : 0;
  const float available = bottom - top - (rows - 1) * gap - under;
  std::vector<Box> cells;
  if (grid.columns == 1) {
    double all = 0;
    for (const Diagram& diagram : sheet.diagrams) all += diagram.height;
    float y = top;
    for (const Diagram& diagram : sheet.diagrams) {
      const float height = available * static_cast<float>(diagram.height / all);
      cells.push_back({std::round(side), std::round(y), std::floor(width), std::floor(height)});
      y += height + gap;
    }
    if (!cells.empty()) cells.back().height += under;
    return cells;
  }
  const float height = available / rows;
  for (std::size_t i = 0; i < sheet.diagrams.size(); ++i) {
    const int row = static_cast<int>(i) / grid.columns, column = static_cast<int>(i) % grid.columns;
    cells.push_back({std::round(side + static_cast<float>(column) * (width + gap)),
                     std::round(top + static_cast<float>(row) * (height + gap)), std::floor(width),
                     std::floor(height)});
  }
  return cells;
}

float addHeading(DrawList& list, const DiagramSheet& sheet, const DiagramSizes& sizes,
                 const Theme& theme) {
  if (sheet.title.empty() && sheet.subtitle.empty()) return std::round(2 * sizes.unit);
  const float side = sheetMargin(sizes), width = static_cast<float>(list.width) - 2 * side;
  float available = 0.3F * static_cast<float>(list.height) - side, top = std::round(0.8F * side);
  const auto least = [&](float size) { return std::max(sizes.minFontSize, std::round(size)); };
  const Paragraph title = paragraph(sheet.title.text, sizes.title, least(0.75F * sizes.title), true,
                                    width, linesIn(available, sizes.title, 2));
  addParagraph(list, title, {side, top}, true, theme.text);
  top += title.height();
  available -= title.height();
  const Paragraph subtitle =
      paragraph(sheet.subtitle.text, sizes.subtitle, least(0.85F * sizes.subtitle), false, width,
                linesIn(available, sizes.subtitle, 3));
  addParagraph(list, subtitle, {side, top}, false, theme.faintText);
  return std::round(top + subtitle.height() + 2 * sizes.unit);
}

float addNote(DrawList& list, const DiagramSheet& sheet, const DiagramSizes& sizes,
              const Theme& theme) {
  const float side = sheetMargin(sizes), width = static_cast<float>(list.width) - 2 * side;
  const auto bottom = static_cast<float>(list.height);
  const float least = std::max(sizes.minFontSize, std::round(0.85F * sizes.note));
  const auto wrappedNote = [&](const std::string& text) {
    return paragraph(text, sizes.note, least, false, width, linesIn(0.2F * bottom, sizes.note, 5));
  };
  // Whole sentences are shown where not all of them fit.
  Paragraph note = wrappedNote(sheet.note.text);
  std::string shorter = sheet.note.text;
  while (isCut(note.lines) && !(shorter = withoutLastSentence(shorter)).empty())
    note = wrappedNote(shorter);
  if (note.lines.empty()) return bottom - std::round(8 * sizes.unit);
  const float top = std::round(bottom - 10 * sizes.unit - note.height());
  addParagraph(list, note, {side, top}, false, theme.faintText);
  return top - std::round(5 * sizes.unit);
}

}  // namespace asperity
