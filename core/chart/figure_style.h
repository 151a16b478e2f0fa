// The style of a figure as a user chooses it: size, letters, lines, title, legend, axes, colours.
// Every option stands once in a table, from which the command line, its help and style files are
// made. A style file is JSON with the same words, {"schema": "asperity-style/1", "font_size": 7,
// ...}; options of the command line replace its values. Options of the content of a chart are
// applied to its Diagrams here; ui/chart applies sizes and positions. Plain values; any thread.
// Failure: InputError that names the option, or file and key.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/shipped_file.h"
#include "core/chart/diagram.h"

namespace asperity {

enum class LegendMode { Automatic, None, Inside, Below };
enum class TickSide { Automatic, Inside, Outside, None };
enum class PanelLetters { None, Small, Capital, Bracketed };

/// The style of one curve; a value that is not given is automatic.
struct CurveStyle {
  std::optional<std::uint32_t> rgb;  // 0xRRGGBB
  std::optional<SeriesMark> mark;
  std::optional<SeriesStroke> stroke;
};

/// Width and height of a picture: pixels, or lengths on paper.
struct PictureSize {
  double width = 0, height = 0;
  double perInch = 0;  // units in an inch: 25.4 for mm; 0: pixels

  bool isOnPaper() const { return perInch > 0; }
};

inline constexpr int kSmallestPicture = 160, kLargestPicture = 16384;  // pixels, of both sides

/// Reads "1200x800", "86mmx60mm", "86x60mm", "3.4inx2.4in"; units: px, mm, cm, in, pt (1/72 in).
/// Empty where it is none of these.
std::optional<PictureSize> parsePictureSize(std::string_view text);

struct FigureStyle {
  std::string size{}, theme{};  // as given; empty: automatic
  std::string font{};           // family; empty: DejaVu Sans
  double dotsPerInch = 0;       // 0: automatic
  double fontSize = 0;          // pt, of the numbers at the axes; 0: automatic
  double lineWidth = 0;         // pt, of curves; 0: automatic
  bool hasTitle = true, hasRegions = true, hasLaw = true, hasFootnote = true;
  bool hasMarker = true, isGrey = false;
  std::string title{};  // instead of the figure's own; empty: that one
  LegendMode legend = LegendMode::Automatic;
  TickSide ticks = TickSide::Automatic;
  PanelLetters letters = PanelLetters::None;
  std::optional<AxisScale> xScale{}, yScale{};
  std::vector<std::pair<std::string, std::string>> labels{};  // what, text
  std::vector<std::pair<std::size_t, CurveStyle>> curves{};   // number from 1 on, style
};

/// The pictures that an option applies to: any picture, charts, or friction curves only. Options of
/// any picture also apply to the picture of the contact.
enum class FigurePart { Picture, Chart, Curve };

struct FigureOption {
  std::string_view word;    // of the command line; in files with _ for -
  std::string_view values;  // as the help shows them
  std::string_view sentence;
  FigurePart part;
  /// Sets the value; returns what is wrong with it, or nothing.
  Message (*set)(FigureStyle& style, const std::string& value);
  bool repeats = false;
};

std::span<const FigureOption> figureOptions();

std::span<const ShippedFile> shippedStyles();

/// Returns the style of a file, or of a shipped name. Throws InputError.
FigureStyle readStyle(const std::string& nameOrFile);

/// Reads a style file's text; `file` is named in errors.
FigureStyle styleFromJson(std::string_view json, const std::string& file);

/// Returns the sheet with the style's title, labels, letters, scales, marks and colours, without
/// what the style leaves out. Throws InputError naming the option where a label or a curve does not
/// exist.
DiagramSheet styled(DiagramSheet sheet, const FigureStyle& style);

}  // namespace asperity
