#include "app/picture_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/command_options.h"
#include "app/output.h"
#include "core/base/input_error.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/font_choice.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr double kPixelsPerInch = 96;

/// Sets width and height from a size in pixels or on paper, at settings.scale.
void readSize(const std::string& text, PictureSettings& settings) {
  const auto fits = [](double pixels) {
    return pixels >= kSmallestPicture && pixels <= kLargestPicture;
  };
  const std::optional<PictureSize> size = parsePictureSize(text);
  const bool isWhole = size && (size->isOnPaper() || (size->width == std::floor(size->width) &&
                                                      size->height == std::floor(size->height)));
  if (!isWhole || (!size->isOnPaper() && !(fits(size->width) && fits(size->height))))
    throw InputError("", "--size",
                     message("{} is not WIDTHxHEIGHT with {} to {} pixels each", shortened(text),
                             kSmallestPicture, kLargestPicture));
  settings.isOnPaper = size->isOnPaper();
  const double density =
      size->isOnPaper() ? kPixelsPerInch * static_cast<double>(settings.scale) / size->perInch : 1;
  const double width = std::round(size->width * density),
               height = std::round(size->height * density);
  if (!fits(width) || !fits(height))
    throw InputError("", "--size",
                     message("{} at {} dpi has {} x {} pixels; {} to {} each are allowed",
                             shortened(text), kPixelsPerInch * static_cast<double>(settings.scale),
                             width, height, kSmallestPicture, kLargestPicture));
  settings.width = static_cast<int>(width);
  settings.height = static_cast<int>(height);
}

float scaleFrom(const std::string& text) {
  const bool isDensity = text.ends_with("dpi");
  double number = 0;
  const bool good =
      readNumber(std::string_view(text).substr(0, text.size() - (isDensity ? 3 : 0)), number) &&
      std::isfinite(number);
  const double scale = isDensity ? number / kPixelsPerInch : number;
  if (!good || scale < 0.25 || scale > 16)
    throw InputError(
        "", "--scale",
        message("{} is not a density: allowed is 0.25 to 16 or 24dpi to 1536dpi", shortened(text)));
  return static_cast<float>(scale);
}

constexpr NamedChoices<const Theme& (*)(), 4> kThemes{
    {{"light", lightTheme}, {"dark", darkTheme}, {"print", printTheme}, {"paper", paperTheme}}};

/// Returns the style of the options: that of a file, changed by each option.
FigureStyle styleFrom(const PictureArguments& arguments) {
  FigureStyle style = arguments.style.empty() ? FigureStyle{} : readStyle(arguments.style);
  for (const auto& [word, value] : arguments.figure)
    for (const FigureOption& option : figureOptions())
      if (option.word == word)
        if (const Message refusal = option.set(style, value); !refusal.empty())
          throw InputError("", "--" + word, refusal);
  if (!arguments.size.empty()) style.size = arguments.size;
  if (!arguments.theme.empty()) style.theme = arguments.theme;
  return style;
}

/// Returns the pixels of the picture to one pixel at 96 per inch.
float chosenScale(const PictureArguments& arguments, const FigureStyle& style, float usual) {
  constexpr float kPaperDensity = 300;  // dpi
  const bool hasDensity =
      std::ranges::any_of(arguments.figure, [](const auto& given) { return given.first == "dpi"; });
  if (!arguments.scale.empty() && hasDensity)
    throw InputError("", "--scale", "cannot be combined with --dpi: both set the density");
  if (!arguments.scale.empty()) return scaleFrom(arguments.scale);
  if (style.dotsPerInch > 0) return static_cast<float>(style.dotsPerInch / kPixelsPerInch);
  const std::optional<PictureSize> size = parsePictureSize(style.size);
  if (size && size->isOnPaper()) return kPaperDensity / static_cast<float>(kPixelsPerInch);
  return style.size.empty() ? usual : 1;
}

/// Returns letters and lines in pixels. A picture with a size on paper has letters of 7 pt, more
/// where it is wider than two columns of a journal, and none below 6 pt.
DiagramFormat diagramFormat(const FigureStyle& style, const PictureSettings& settings) {
  constexpr double kPaperLetters = 7, kMinLetters = 6, kTwoColumns = 178 / 25.4;  // pt, inches
  const double inch = kPixelsPerInch * static_cast<double>(settings.scale), point = inch / 72;
  DiagramFormat format;
  format.legend = style.legend;
  format.ticks = style.ticks;
  double letters = style.fontSize;
  if (letters == 0 && settings.isOnPaper)
    letters = kPaperLetters * std::max(1.0, settings.width / inch / kTwoColumns);
  format.fontSize = static_cast<float>(letters * point);
  format.lineWidth = static_cast<float>(style.lineWidth * point);
  if (letters > 0) format.minFontSize = static_cast<float>(std::min(letters, kMinLetters) * point);
  return format;
}

constexpr NamedChoices<PixelBackend, 4> kBackends{{{"auto", PixelBackend::Automatic},
                                                   {"raster", PixelBackend::Raster},
                                                   {"osmesa", PixelBackend::Osmesa},
                                                   {"egl", PixelBackend::Egl}}};

}  // namespace

nlohmann::ordered_json PictureSettings::json() const {
  nlohmann::ordered_json json = {{"size", fmt::format("{}x{}", width, height)},
                                 {"scale", scale},
                                 {"theme", themeName},
                                 {"transparent", transparent}};
  addLanguage(json);
  return json;
}

void chooseLanguage(const std::string& code) {
  std::vector<std::string_view> codes;
  for (const Language& language : languages()) codes.push_back(language.code);
  if (std::ranges::find(codes, code) == codes.end())
    throw InputError("", "--language", notOneOf(code, codes));
  useLanguage(code);
}

void checkUseful(const PictureArguments& arguments, const std::vector<std::string>& files) {
  bool hasPicture = false, hasPixels = false;
  for (const std::string& file : files) {
    const std::string extension = fileExtension(file);
    hasPicture |= !isTableFile(file);
    hasPixels |=
        !isTableFile(file) && extension != ".svg" && extension != ".pdf" && extension != ".eps";
  }
  if (!hasPicture)
    refuseGiven({{"--size", !arguments.size.empty()},
                 {"--scale", !arguments.scale.empty()},
                 {"--theme", !arguments.theme.empty()},
                 {"--style", !arguments.style.empty()},
                 {"--transparent", arguments.transparent},
                 {"--backend", !arguments.backend.empty()}},
                "belongs to pictures, and no output is one");
  if (!hasPicture && !arguments.figure.empty())
    throw InputError("", "--" + arguments.figure.front().first,
                     "belongs to pictures, and no output is one");
  if (!hasPixels)
    refuseGiven({{"--backend", !arguments.backend.empty()}},
                "draws pixels; .svg, .pdf and .eps are written without them");
}

void addPictureOptions(CLI::App& command, PictureArguments& arguments, PictureDefaults defaults,
                       FigurePart most) {
  const std::string size =
      defaults.size.empty() ? fmt::format("{}x{}", defaults.width, defaults.height) : defaults.size;
  const auto add = [&](const char* option, auto& value, const std::string& sentence) {
    return command.add_option(option, value, sentence)->group(kPictureGroup);
  };
  add("--size", arguments.size,
      "Width and height in pixels, or on paper as 86mmx60mm (px, mm, cm, in, pt); several panels "
      "may need a larger height on paper (default: " +
          size + " times the scale)")
      ->type_name("WxH");
  add("--scale", arguments.scale,
      "Density: 2 doubles texts and line widths; or 300dpi (default: 1, which is 96dpi)");
  add("--theme", arguments.theme,
      "light, dark, print, or paper: a contact in light tints (default: " + defaults.theme + ")");
  arguments.defaults = std::move(defaults);
  std::string names;
  for (const std::string_view name : namesOf(shippedStyles())) names += std::string(name) + ", ";
  add("--style", arguments.style,
      "Values of these options from a file, or shipped: " + names.substr(0, names.size() - 2))
      ->type_name("NAME|FILE");
  command.add_flag("--transparent", arguments.transparent, "No background")->group(kPictureGroup);
  add("--backend", arguments.backend,
      "What draws pixels: raster, the program itself, or OpenGL by osmesa or egl (default: auto, "
      "which is raster)");
  for (const FigureOption& row : figureOptions()) {
    if (row.part > most || command.get_option_no_throw("--" + std::string(row.word))) continue;
    CLI::Option* option = command.add_option_function<std::vector<std::string>>(
        "--" + std::string(row.word),
        [&arguments, word = std::string(row.word)](const std::vector<std::string>& values) {
          for (const std::string& value : values) arguments.figure.emplace_back(word, value);
        },
        std::string(row.sentence));
    option->type_name(std::string(row.values))->group(kPictureGroup);
    if (row.repeats)
      mayRepeat(option);
    else
      option->expected(1);
  }
}

void refuseChartOptions(const PictureArguments& arguments, const Message& why) {
  for (const auto& [word, value] : arguments.figure)
    for (const FigureOption& option : figureOptions())
      if (option.word == word && option.part != FigurePart::Picture)
        throw InputError("", "--" + word, why);
}

PictureDefaults printDefaults(const DiagramSheet& sheet) {
  const DiagramOptions print = printOptions(sheet);
  return {static_cast<int>(std::lround(static_cast<float>(print.width) / print.scale)),
          static_cast<int>(std::lround(static_cast<float>(print.height) / print.scale)), "print",
          print.scale};
}

PictureSettings pictureSettings(const PictureArguments& arguments,
                                const PictureDefaults& defaults) {
  PictureSettings settings;
  settings.style = styleFrom(arguments);
  const FigureStyle& style = settings.style;
  settings.scale = chosenScale(arguments, style, defaults.scale);
  const auto pixels = [&](int length) {
    return static_cast<int>(std::lround(static_cast<float>(length) * settings.scale));
  };
  readSize(style.size.empty()
               ? fmt::format("{}x{}", pixels(defaults.width), pixels(defaults.height))
               : style.size,
           settings);
  useFontFamily(style.font);
  settings.themeName = style.theme.empty() ? defaults.theme : style.theme;
  settings.theme = chosen(kThemes, settings.themeName, "--theme")();
  settings.transparent = arguments.transparent;
  if (!arguments.backend.empty())
    settings.backend = chosen(kBackends, arguments.backend, "--backend");
  settings.format = diagramFormat(style, settings);
  return settings;
}

DiagramOptions PictureSettings::diagramOptions(float minTextSize) const {
  DiagramOptions options{width, height, scale, theme, minTextSize};
  options.format = format;
  if (transparent) options.theme.background.a = 0;
  return options;
}

PictureProperties PictureSettings::properties(const std::string& title,
                                              const std::string& origin) const {
  return {title, origin, scale, isOnPaper};
}

DrawList drawSheet(const DiagramSheet& sheet, const PictureSettings& settings, float minTextSize) {
  const DiagramSheet shown = styled(sheet, settings.style);
  DiagramOptions options = settings.diagramOptions(minTextSize);
  if (settings.isOnPaper) options.height = heightInPrint(shown, options);
  DrawList list = composeDiagrams(shown, options);
  if (settings.style.isGrey) removeColours(list);
  return list;
}

namespace {

constexpr double kFarthest = 1e9;  // m, a million periods of the longest line

constexpr double kMaxPeriods = 50;        // largest width of a view
constexpr double kMinPeriods = 1e-9;      // smallest width of a view
constexpr double kFarthestPeriods = 1e6;  // largest distance from 0
/// Heights that would be exaggerated by a smaller factor are drawn to scale: so rough a surface,
/// such as a road, is shown undistorted.
constexpr double kNearlyToScale = 5.5;
constexpr const char *kView = "--view", *kHeights = "--heights", *kColours = "--colours-to",
                     *kExaggeration = "--exaggeration", *kProbe = "--probe",
                     *kMagnify = "--magnify";

void checkPosition(const char* option, const std::optional<double>& position, double length) {
  if (position && !(std::abs(*position) <= kFarthestPeriods * length))
    throw InputError("", option,
                     message("{} m is not within {} m of 0", plainNumber(*position),
                             printedNumber(kFarthestPeriods * length, 6)));
}

/// Sets heights around the middle of the fitted ones so that they are drawn `exaggeration` times as
/// large as lengths. The labels of the new heights change the plot's width a little, so the
/// computation is repeated.
void exaggerate(double exaggeration, const Frame& frame, ContactPictureOptions& options) {
  const ContactView fitted = resolvedView(frame, options.view);
  const double middle = 0.5 * (fitted.bottom + fitted.top);
  constexpr int kTurns = 4;
  for (int i = 0; i < kTurns; ++i) {
    const Box plot = contactPlotArea(frame, options);
    const double size = fitted.width * plot.height / (plot.width * exaggeration);
    options.view.bottom = middle - 0.5 * size;
    options.view.top = middle + 0.5 * size;
  }
}

/// Returns how many times as large as lengths heights are drawn.
double drawnExaggeration(const Frame& frame, const ContactPictureOptions& options) {
  const ContactView view = resolvedView(frame, options.view);
  const Box plot = contactPlotArea(frame, options);
  return plot.height / (view.top - view.bottom) / (plot.width / view.width);
}

}  // namespace

const char* ViewArguments::firstOption() const {
  return firstGiven({{kView, !xRange.empty()},
                     {kHeights, !heights.empty()},
                     {kExaggeration, exaggeration.has_value()},
                     {kColours, coloursTo.has_value()},
                     {kProbe, probe.has_value()},
                     {kMagnify, magnified.has_value()}});
}

double ViewArguments::width() const {
  if (xRange.empty()) return 0;
  const NumberRange range = rangeFrom(kView, xRange, "m");
  return range.to - range.from;
}

double ViewArguments::finest() const {
  constexpr double kNothing = 1e-300;  // finer than any line
  return probe ? kNothing : width();
}

FrameFields ViewArguments::fields(ContactOverlay overlay) const {
  FrameFields fields = fieldsFor(overlay);
  fields.lineSlope = probe.has_value();
  return fields;
}

void ViewArguments::addTo(nlohmann::ordered_json& picture) const {
  if (!xRange.empty()) picture["view"] = xRange;
  if (!heights.empty()) picture["heights"] = heights;
  if (exaggeration) picture["exaggeration"] = *exaggeration;
  if (coloursTo) picture["colours_to"] = *coloursTo;
  if (probe) picture["probe"] = *probe;
  if (magnified) picture["magnified"] = *magnified;
}

void addViewOptions(CLI::App& command, ViewArguments& arguments) {
  command
      .add_option(kView, arguments.xRange, "Part of the line to show, in m (default: one period)")
      ->type_name("FROM:TO");
  command
      .add_option(kHeights, arguments.heights,
                  "Heights to show, in m above the undeformed surface (default: those in the part "
                  "of the line that is shown; in a film, those of all that passes)")
      ->type_name("FROM:TO");
  setNumberRange(
      command.add_option(kExaggeration, arguments.exaggeration,
                         "Draw heights this many times as large as lengths, instead of --heights"),
      1e-6, 1e12);
  setNumberRange(
      command.add_option(
          kColours, arguments.coloursTo,
          "Value at the bright end of the colours, in N/m, s or W/m (default: automatic)"),
      1e-300, 1e300);
  setNumberRange(command.add_option(kProbe, arguments.probe,
                                    "Show a crosshair with readings at this position"),
                 -kFarthest, kFarthest, "m");
  setNumberRange(
      command.add_option(kMagnify, arguments.magnified, "Show a magnified inset of this position"),
      -kFarthest, kFarthest, "m");
}

void checkView(const ViewArguments& arguments, ContactOverlay overlay, double length) {
  if (!arguments.xRange.empty()) {
    const NumberRange range = rangeFrom(kView, arguments.xRange, "m");
    const double width = arguments.width();
    if (width > kMaxPeriods * length || width < kMinPeriods * length)
      throw InputError(
          "", kView,
          message("{} is not {} wide, of which the most are {} periods of the line",
                  shortened(arguments.xRange),
                  rangeText(kMinPeriods * length, kMaxPeriods * length, "m"), kMaxPeriods));
    checkPosition(kView, range.from, length);
  }
  if (!arguments.heights.empty()) rangeFrom(kHeights, arguments.heights, "m");
  if (!arguments.heights.empty() && arguments.exaggeration)
    throw InputError("", kExaggeration, "cannot be combined with --heights: both set the heights");
  if (arguments.coloursTo && overlay == ContactOverlay::None)
    throw InputError("", kColours, "there are no colours with --overlay none");
  checkPosition(kProbe, arguments.probe, length);
  checkPosition(kMagnify, arguments.magnified, length);
}

void applyView(const ViewArguments& arguments, const Frame& frame, bool isFilm,
               ContactPictureOptions& options) {
  ContactView& view = options.view;
  if (!arguments.xRange.empty()) {
    const NumberRange range = rangeFrom(kView, arguments.xRange, "m");
    view.left = range.from;
    view.width = arguments.width();
    if (!isFilm) fitToPart(frame, view);
  }
  if (arguments.coloursTo) setColourMaximum(view, options.overlay, *arguments.coloursTo);
  options.probe = arguments.probe;
  if (arguments.magnified) options.magnifier = Magnifier{*arguments.magnified};
  if (!arguments.heights.empty()) {
    const NumberRange range = rangeFrom(kHeights, arguments.heights, "m");
    view.bottom = range.from;
    view.top = range.to;
  } else if (arguments.exaggeration) {
    exaggerate(*arguments.exaggeration, frame, options);
  } else if (arguments.xRange.empty()) {
    const double natural = drawnExaggeration(frame, options);
    if (natural > 1 && natural <= kNearlyToScale) exaggerate(1, frame, options);
  }
}

}  // namespace asperity
