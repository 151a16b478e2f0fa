#include "core/chart/figure_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/chart/curve_diagram.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestStyle = std::size_t{1} << 20;  // bytes

/// Sets one of several named values; returns why the word is refused.
template <class Value, class Target, std::size_t N>
Message choose(const NamedChoices<Value, N>& words, std::string_view word, Target& target) {
  const auto choice = findChoice(words, word);
  if (!choice) return notOneOf(word, words);
  target = *choice;
  return {};
}

constexpr NamedChoices<bool, 2> kOnOff{{{"on", true}, {"off", false}}};
constexpr NamedChoices<LegendMode, 4> kLegends{{{"auto", LegendMode::Automatic},
                                                {"none", LegendMode::None},
                                                {"inside", LegendMode::Inside},
                                                {"below", LegendMode::Below}}};
constexpr NamedChoices<TickSide, 4> kTicks{{{"auto", TickSide::Automatic},
                                            {"inside", TickSide::Inside},
                                            {"outside", TickSide::Outside},
                                            {"none", TickSide::None}}};
constexpr NamedChoices<PanelLetters, 4> kLetters{{{"none", PanelLetters::None},
                                                  {"a", PanelLetters::Small},
                                                  {"A", PanelLetters::Capital},
                                                  {"(a)", PanelLetters::Bracketed}}};
constexpr NamedChoices<SeriesMark, 6> kMarks{{{"circle", SeriesMark::Circle},
                                              {"square", SeriesMark::Square},
                                              {"triangle", SeriesMark::Triangle},
                                              {"diamond", SeriesMark::Diamond},
                                              {"ring", SeriesMark::Ring},
                                              {"no-marker", SeriesMark::None}}};
constexpr NamedChoices<SeriesStroke, 4> kStrokes{{{"solid", SeriesStroke::Solid},
                                                  {"dashed", SeriesStroke::Dashed},
                                                  {"dotted", SeriesStroke::Dotted},
                                                  {"no-line", SeriesStroke::None}}};
// Okabe and Ito (2008), and greys.
constexpr NamedChoices<std::uint32_t, 12> kColours{{{"black", 0x000000},
                                                    {"grey", 0x808080},
                                                    {"gray", 0x808080},
                                                    {"orange", 0xE69F00},
                                                    {"skyblue", 0x56B4E9},
                                                    {"green", 0x009E73},
                                                    {"yellow", 0xF0E442},
                                                    {"blue", 0x0072B2},
                                                    {"vermilion", 0xD55E00},
                                                    {"red", 0xD55E00},
                                                    {"purple", 0xCC79A7},
                                                    {"white", 0xFFFFFF}}};

Message setNumber(double& target, const std::string& text, double least, double most,
                  const char* unit) {
  std::string_view number = text;
  if (number.ends_with(unit)) number.remove_suffix(std::string_view(unit).size());
  double value = 0;
  if (!readNumber(number, value) || !std::isfinite(value))
    return message("'{}' is not a number; allowed is {}", shortened(text),
                   rangeText(least, most, unit));
  if (value < least || value > most)
    return message("{} is outside {}", shortened(text), rangeText(least, most, unit));
  target = value;
  return {};
}

bool isHex(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// Reads "#d55e00" or a name.
bool readColour(std::string_view word, CurveStyle& curve) {
  if (word.size() == 7 && word[0] == '#' && std::all_of(word.begin() + 1, word.end(), isHex)) {
    curve.rgb = static_cast<std::uint32_t>(std::stoul(std::string(word.substr(1)), nullptr, 16));
    return true;
  }
  return choose(kColours, word, curve.rgb).empty();
}

/// Reads "2=#d55e00,circle,dashed".
Message addCurve(FigureStyle& style, const std::string& text) {
  const std::size_t equals = text.find('=');
  std::size_t number = 0;
  if (equals == text.npos || !readNumber(std::string_view(text).substr(0, equals), number) ||
      number < 1 || number > 1000)
    return message("'{}' is not NUMBER=WORDS with the number of a curve in the legend",
                   shortened(text));
  CurveStyle curve;
  for (const std::string_view word : splitText(std::string_view(text).substr(equals + 1), ",")) {
    if (!readColour(word, curve) && !choose(kMarks, word, curve.mark).empty() &&
        !choose(kStrokes, word, curve.stroke).empty())
      return message(
          "'{}' is neither a colour (#d55e00, black, grey, orange, skyblue, green, yellow, blue, "
          "vermilion, purple), a marker (circle, square, triangle, diamond, ring, no-marker) nor a "
          "line (solid, dashed, dotted, no-line)",
          shortened(word));
  }
  style.curves.emplace_back(number, curve);
  return {};
}

template <const auto& kChoices, auto kMember>
Message setChoice(FigureStyle& style, const std::string& text) {
  return choose(kChoices, text, style.*kMember);
}

template <auto kMember>
Message setText(FigureStyle& style, const std::string& text) {
  style.*kMember = text;
  return {};
}

constexpr std::array<FigureOption, 19> kOptions{{
    {"size", "WxH", "Width and height, in pixels or as 86mmx60mm (px, mm, cm, in, pt)",
     FigurePart::Picture,
     [](FigureStyle& style, const std::string& text) -> Message {
       if (!parsePictureSize(text))
         return message("{} is not WIDTHxHEIGHT in px, mm, cm, in or pt", shortened(text));
       style.size = text;
       return {};
     }},
    {"dpi", "DPI", "Pixels per inch (default: 96; 300 for a size on paper)", FigurePart::Picture,
     [](FigureStyle& style, const std::string& text) {
       return setNumber(style.dotsPerInch, text, 24, 1536, "dpi");
     }},
    {"theme", "NAME", "light, dark, print, or paper: a contact in light tints for print",
     FigurePart::Picture, setText<&FigureStyle::theme>},
    {"font", "FAMILY", "Font of all texts, by the name of its family (default: DejaVu Sans)",
     FigurePart::Picture, setText<&FigureStyle::font>},
    {"font-size", "PT", "Size of the numbers at the axes, in points; other texts follow",
     FigurePart::Picture,
     [](FigureStyle& style, const std::string& text) {
       return setNumber(style.fontSize, text, 4, 72, "pt");
     }},
    {"line-width", "PT", "Width of curves, in points", FigurePart::Picture,
     [](FigureStyle& style, const std::string& text) {
       return setNumber(style.lineWidth, text, 0.1, 20, "pt");
     }},
    {"title", "none|TEXT", "No heading, or another one", FigurePart::Picture,
     [](FigureStyle& style, const std::string& text) -> Message {
       style.hasTitle = text != "none";
       style.title = style.hasTitle && text != "auto" ? text : std::string();
       return {};
     }},
    {"greyscale", "on|off", "Shades of grey; lines differ in strokes and markers",
     FigurePart::Picture, setChoice<kOnOff, &FigureStyle::isGrey>},
    {"legend", "PLACE", "none, inside the frame, below it, or auto", FigurePart::Chart,
     setChoice<kLegends, &FigureStyle::legend>},
    {"footnote", "on|off", "The remark under a chart", FigurePart::Chart,
     setChoice<kOnOff, &FigureStyle::hasFootnote>},
    {"marker", "on|off", "The mark at the state of the scene", FigurePart::Chart,
     setChoice<kOnOff, &FigureStyle::hasMarker>},
    {"ticks", "SIDE",
     "Tick marks inside or outside of the frame, none, or auto: inside with the themes for print, "
     "else outside",
     FigurePart::Chart, setChoice<kTicks, &FigureStyle::ticks>},
    {"x-scale", "SCALE", "x-axis log or linear", FigurePart::Chart,
     setChoice<kAxisScales, &FigureStyle::xScale>},
    {"y-scale", "SCALE", "y-axis log or linear", FigurePart::Chart,
     setChoice<kAxisScales, &FigureStyle::yScale>},
    {"labels", "KEY=TEXT",
     "Another text: KEY is x, y (of the second panel x2, y2), the number of a curve in the legend, "
     "or its present text; may be repeated",
     FigurePart::Chart,
     [](FigureStyle& style, const std::string& text) -> Message {
       const std::size_t equals = text.find('=');
       if (equals == text.npos || equals == 0)
         return message("'{}' is not KEY=TEXT", shortened(text));
       style.labels.emplace_back(text.substr(0, equals), text.substr(equals + 1));
       return {};
     },
     true},
    {"curve-style", "N=WORDS",
     "Colour, marker and line of the N-th curve in the legend, e.g. 2=#d55e00,square,dashed; may "
     "be repeated",
     FigurePart::Chart, addCurve, true},
    {"panel-letters", "FORM", "a, A or (a) before the names of panels, or none", FigurePart::Chart,
     setChoice<kLetters, &FigureStyle::letters>},
    {"regions", "on|off", "Regions I to IV of a friction curve", FigurePart::Curve,
     setChoice<kOnOff, &FigureStyle::hasRegions>},
    {"law", "on|off", "The line of Eq. (11)", FigurePart::Curve,
     setChoice<kOnOff, &FigureStyle::hasLaw>},
}};

std::string optionKey(const FigureOption& option) {
  std::string key(option.word);
  std::ranges::replace(key, '-', '_');
  return key;
}

std::string optionText(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  return jsonLine(value);
}

void setFrom(FigureStyle& style, const FigureOption& option, const Json& value) {
  const Message refusal = option.set(style, optionText(value));
  if (!refusal.empty()) throw InputError("", optionKey(option), refusal);
}

/// Adds the parts of a text that `sentences` joined.
void addParts(const Message& text, std::vector<Message>& parts) {
  if (text.text == "%1 %2" && text.values.size() == 2) {
    addParts(text.values[0], parts);
    addParts(text.values[1], parts);
  } else if (!text.empty()) {
    parts.push_back(text);
  }
}

constexpr std::string_view kRegionsSentence = "Regions as read from the curve",
                           kCrossSentence = "Cross: the scene's own state.";

/// Removes the sentence of the note that begins so.
void leaveOutNote(DiagramSheet& sheet, std::string_view begin) {
  std::vector<Message> parts;
  addParts(sheet.note, parts);
  std::erase_if(parts, [&](const Message& part) { return part.text.starts_with(begin); });
  sheet.note = sentences(parts);
}

void leaveOutRegions(DiagramSheet& sheet) {
  for (Diagram& diagram : sheet.diagrams) diagram.spans.clear();
  leaveOutNote(sheet, kRegionsSentence);
}

void leaveOutMarker(DiagramSheet& sheet) {
  for (Diagram& diagram : sheet.diagrams) diagram.marker.reset();
  leaveOutNote(sheet, kCrossSentence);
}

/// Returns the names of curves in the order of the legends: data, then theory, of each diagram;
/// each name once.
std::vector<std::string> curveNames(const DiagramSheet& sheet) {
  std::vector<std::string> names;
  for (const Diagram& diagram : sheet.diagrams)
    for (const bool isTheory : {false, true})
      for (const DiagramSeries& series : diagram.series) {
        const std::string name = series.name.english();
        if (series.isTheory == isTheory && !name.empty() &&
            std::ranges::find(names, name) == names.end())
          names.push_back(name);
      }
  return names;
}

/// Calls the function with every series of this name, and with those without a name that are parts
/// of it: values beyond an axis have marks of their own.
template <class Use>
void forEachNamed(DiagramSheet& sheet, const std::string& name, const Use& use) {
  for (Diagram& diagram : sheet.diagrams)
    for (DiagramSeries& series : diagram.series) {
      const bool isPart = series.name.empty() && series.id != -1 &&
                          std::ranges::any_of(diagram.series, [&](const DiagramSeries& other) {
                            return other.id == series.id && other.name.english() == name;
                          });
      if (isPart || series.name.english() == name) use(series);
    }
}

/// Returns the axis "x", "y", "x2", "y2", ...; null where there is none.
DiagramAxis* axisNamed(DiagramSheet& sheet, const std::string& key) {
  if (key.empty() || (key[0] != 'x' && key[0] != 'y')) return nullptr;
  std::size_t panel = 1;
  if (key.size() > 1 && !readNumber(std::string_view(key).substr(1), panel)) return nullptr;
  if (panel < 1 || panel > sheet.diagrams.size()) return nullptr;
  Diagram& diagram = sheet.diagrams[panel - 1];
  return key[0] == 'x' ? &diagram.x : &diagram.y;
}

void setLabel(DiagramSheet& sheet, const std::vector<std::string>& names, const std::string& key,
              const std::string& text) {
  if (DiagramAxis* axis = axisNamed(sheet, key)) {
    axis->title = Message::name(text);
    return;
  }
  std::size_t number = 0;
  std::string name = key;
  if (readNumber(std::string_view(key), number) && number >= 1 && number <= names.size())
    name = names[number - 1];
  if (std::ranges::find(names, name) == names.end())
    throw InputError("", "--labels",
                     message("'{}' is neither an axis (x, y) nor a curve of this figure, which has "
                             "{} with a name",
                             shortened(key), names.size()));
  forEachNamed(sheet, name, [&](DiagramSeries& series) {
    if (!series.name.empty()) series.name = Message::name(text);
  });
}

void setLetters(DiagramSheet& sheet, PanelLetters form) {
  if (form == PanelLetters::None) return;
  for (std::size_t i = 0; i < sheet.diagrams.size(); ++i) {
    const char letter =
        static_cast<char>((form == PanelLetters::Capital ? 'A' : 'a') + static_cast<int>(i % 26));
    const std::string text =
        form == PanelLetters::Bracketed ? fmt::format("({})", letter) : std::string(1, letter);
    Message& title = sheet.diagrams[i].title;
    title = title.empty() ? Message::name(text) : sentences({Message::name(text), title});
  }
}

/// Gives solid lines different strokes, because greys alone cannot be distinguished.
void cycleStrokes(DiagramSheet& sheet) {
  constexpr std::array kStroke{SeriesStroke::Solid, SeriesStroke::Dashed, SeriesStroke::Dotted};
  for (Diagram& diagram : sheet.diagrams) {
    std::size_t next = 0;
    for (DiagramSeries& series : diagram.series) {
      const bool counts = !series.isTheory && !series.isBand && std::isnan(series.ramp) &&
                          series.stroke == SeriesStroke::Solid && !series.name.empty();
      if (counts) series.stroke = kStroke[next++ % kStroke.size()];
    }
  }
}

/// Orders the curves: that of the scene first, then the others as given. In the window it is the
/// last one, over the others.
void putPresentFirst(DiagramSheet& sheet) {
  for (Diagram& diagram : sheet.diagrams) {
    std::vector<DiagramSeries>& series = diagram.series;
    const auto pinned = std::ranges::find_if(
        series, [](const DiagramSeries& one) { return one.id > kPresentCurve; });
    const auto present = std::ranges::find(series, kPresentCurve, &DiagramSeries::id);
    if (pinned < present && present != series.end()) std::rotate(pinned, present, present + 1);
  }
}

void setScales(DiagramSheet& sheet, const FigureStyle& style) {
  for (std::size_t i = 0; i < sheet.diagrams.size(); ++i) {
    if (style.xScale) sheet.diagrams[i].x.scale = *style.xScale;
    // Panels under a common axis show other quantities than the first one, often of both signs.
    if (style.yScale && (i == 0 || !sheet.sharesAxis)) sheet.diagrams[i].y.scale = *style.yScale;
  }
}

}  // namespace

std::optional<PictureSize> parsePictureSize(std::string_view text) {
  struct PaperUnit {
    std::string_view name;
    double perInch;
  };
  constexpr std::array<PaperUnit, 5> units{
      {{"px", 0}, {"mm", 25.4}, {"cm", 2.54}, {"in", 1}, {"pt", 72}}};
  // The "x" between the numbers is the one that is not of "px".
  std::size_t cross = text.find('x');
  if (cross != text.npos && cross > 0 && text[cross - 1] == 'p') cross = text.find('x', cross + 1);
  if (cross == text.npos) return std::nullopt;
  std::string_view sides[2] = {text.substr(0, cross), text.substr(cross + 1)};
  const PaperUnit* found[2] = {nullptr, nullptr};
  double numbers[2] = {0, 0};
  for (int i = 0; i < 2; ++i) {
    for (const PaperUnit& unit : units)
      if (sides[i].ends_with(unit.name)) found[i] = &unit;
    if (found[i]) sides[i].remove_suffix(found[i]->name.size());
    while (sides[i].ends_with(' ')) sides[i].remove_suffix(1);
    if (!readNumber(sides[i], numbers[i]) || !(std::isfinite(numbers[i]) && numbers[i] > 0))
      return std::nullopt;
  }
  if (found[0] && !found[1]) return std::nullopt;
  const PaperUnit* width = found[0] ? found[0] : found[1];
  const double perInch = width ? width->perInch : 0, other = found[1] ? found[1]->perInch : 0;
  if ((perInch > 0) != (other > 0)) return std::nullopt;
  PictureSize size{numbers[0], numbers[1], perInch};
  if (perInch > 0) size.height *= perInch / other;
  return size;
}

std::span<const FigureOption> figureOptions() {
  return kOptions;
}

FigureStyle styleFromJson(std::string_view text, const std::string& file) {
  constexpr int kDeepest = 4;
  try {
    const Json json =
        parseJson(text, kDeepest, "a style is JSON: {\"schema\": \"asperity-style/1\", ...}");
    if (!json.is_object()) throw InputError("", "", "a style is an object of options");
    FigureStyle style;
    std::vector<std::string> known{"schema"};
    for (const FigureOption& option : kOptions) known.push_back(optionKey(option));
    for (const auto& [key, value] : json.items()) {
      if (key == "schema") {
        if (value != "asperity-style/1")
          throw InputError("", "schema", "is not asperity-style/1, which a style begins with");
        continue;
      }
      const auto option = std::ranges::find(kOptions, key, optionKey);
      if (option == kOptions.end()) {
        const std::vector<std::string_view> words(known.begin(), known.end());
        const std::string_view nearest = nearestWord(key, words);
        throw InputError("", key,
                         nearest.empty()
                             ? Message("is not an option of a style")
                             : message("is not an option of a style; did you mean {}?", nearest));
      }
      if (value.is_array() && option->repeats)
        for (const Json& one : value) setFrom(style, *option, one);
      else if (value.is_object() || value.is_array() || value.is_null())
        throw InputError("", key, "is a text, a number, true or false");
      else
        setFrom(style, *option, value);
    }
    return style;
  } catch (const InputError& error) {
    throw error.in(file);
  }
}

FigureStyle readStyle(const std::string& nameOrFile) {
  if (const ShippedFile* style = findShipped(shippedStyles(), nameOrFile))
    return styleFromJson(style->json, nameOrFile);
  std::error_code error;
  if (!std::filesystem::exists(nameOrFile, error))
    throw InputError("", "--style",
                     message("'{}' is neither a file nor one of {}", shortened(nameOrFile),
                             namesWithCommas(namesOf(shippedStyles()))));
  return styleFromJson(readRegularFile(nameOrFile, kLargestStyle), nameOrFile);
}

DiagramSheet styled(DiagramSheet sheet, const FigureStyle& style) {
  if (!style.hasTitle) sheet.title = sheet.subtitle = {};
  if (!style.title.empty()) sheet.title = Message::name(style.title);
  if (!style.hasRegions) leaveOutRegions(sheet);
  if (!style.hasMarker) leaveOutMarker(sheet);
  if (!style.hasFootnote) sheet.note = {};
  if (!style.hasLaw)
    for (Diagram& diagram : sheet.diagrams)
      std::erase_if(diagram.series, [](const DiagramSeries& series) {
        return series.isTheory && series.name.text == "Eq. (11)";
      });
  putPresentFirst(sheet);
  if (style.isGrey) cycleStrokes(sheet);
  const std::vector<std::string> names = curveNames(sheet);
  for (const auto& [number, curve] : style.curves) {
    if (number > names.size())
      throw InputError(
          "", "--curve-style",
          message("there is no curve {} in the legend, which has {}", number, names.size()));
    forEachNamed(sheet, names[number - 1], [&](DiagramSeries& series) {
      if (curve.rgb) series.rgb = curve.rgb;
      // A series without a name belongs to the named one, by its own marks.
      if (series.name.empty()) return;
      if (curve.mark) series.mark = *curve.mark;
      if (curve.stroke) series.stroke = *curve.stroke;
    });
  }
  for (const auto& [key, text] : style.labels) setLabel(sheet, names, key, text);
  setScales(sheet, style);
  setLetters(sheet, style.letters);
  return sheet;
}

}  // namespace asperity
