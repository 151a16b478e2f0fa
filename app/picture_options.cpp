#include "app/picture_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/command_options.h"
#include "app/output.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/png_file.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr int kSmallest = 160, kLargest = 16384;  // of width and height in pixels
constexpr double kPixelsPerInch = 96;

void readSize(const std::string& text, PictureSettings& settings) {
  const std::size_t cross = text.find('x');
  const std::string_view all = text;
  const bool good = cross != std::string::npos &&
                    readNumber(all.substr(0, cross), settings.width) &&
                    readNumber(all.substr(cross + 1), settings.height);
  const auto fits = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!good || !fits(settings.width) || !fits(settings.height))
    throw InputError("", "--size",
                     message("{} is not WIDTHxHEIGHT with {} to {} pixels each", shortened(text),
                             kSmallest, kLargest));
}

float scaleFrom(const std::string& text) {
  const bool isDensity = text.ends_with("dpi");
  double number = 0;
  const bool good =
      readNumber(std::string_view(text).substr(0, text.size() - (isDensity ? 3 : 0)), number) &&
      std::isfinite(number);
  const double scale = isDensity ? number / kPixelsPerInch : number;
  if (!good || scale < 0.25 || scale > 16)
    throw InputError("", "--scale",
                     message("{} is neither 0.25 to 16 nor 24dpi to 1536dpi", shortened(text)));
  return static_cast<float>(scale);
}

constexpr NamedChoices<const Theme& (*)(), 3> kThemes{
    {{"light", lightTheme}, {"dark", darkTheme}, {"print", printTheme}}};

constexpr NamedChoices<PixelBackend, 3> kBackends{{{"auto", PixelBackend::Automatic},
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
    const std::string extension = extensionOf(file);
    const bool isTable = extension == ".csv" || extension == ".json";
    hasPicture |= !isTable;
    hasPixels |= !isTable && extension != ".svg" && extension != ".pdf";
  }
  const auto refuse = [](const char* option, bool given, const char* why) {
    if (given) throw InputError("", option, why);
  };
  if (!hasPicture)
    for (const auto& [option, given] : {std::pair{"--size", !arguments.size.empty()},
                                        {"--scale", !arguments.scale.empty()},
                                        {"--theme", !arguments.theme.empty()},
                                        {"--transparent", arguments.transparent},
                                        {"--backend", !arguments.backend.empty()}})
      refuse(option, given, "belongs to pictures, and no output is one");
  if (!hasPixels)
    refuse("--backend", !arguments.backend.empty(),
           "draws pixels; .svg and .pdf are written without them");
}

void addPictureOptions(CLI::App& command, PictureArguments& arguments,
                       const std::string& defaultSize, const std::string& defaultTheme) {
  command
      .add_option("--size", arguments.size,
                  "Width and height in pixels (default: " + defaultSize + " times the scale)")
      ->type_name("WxH");
  command.add_option(
      "--scale", arguments.scale,
      "Density: 2 doubles texts and line widths; or 300dpi (default: 1, which is 96dpi)");
  command.add_option("--theme", arguments.theme,
                     "light, dark or print (default: " + defaultTheme + ")");
  command.add_flag("--transparent", arguments.transparent, "No background");
  command.add_option(
      "--backend", arguments.backend,
      "OpenGL library: osmesa, egl, or auto, the first that is available (default: auto)");
}

PictureSettings pictureSettings(const PictureArguments& arguments,
                                const PictureDefaults& defaults) {
  PictureSettings settings;
  if (!arguments.scale.empty()) settings.scale = scaleFrom(arguments.scale);
  settings.width =
      static_cast<int>(std::lround(static_cast<float>(defaults.width) * settings.scale));
  settings.height =
      static_cast<int>(std::lround(static_cast<float>(defaults.height) * settings.scale));
  readSize(arguments.size.empty() ? fmt::format("{}x{}", settings.width, settings.height)
                                  : arguments.size,
           settings);
  settings.themeName = arguments.theme.empty() ? defaults.theme : arguments.theme;
  settings.theme = chosenFrom(kThemes, settings.themeName, "--theme")();
  settings.transparent = arguments.transparent;
  if (!arguments.backend.empty())
    settings.backend = chosenFrom(kBackends, arguments.backend, "--backend");
  return settings;
}

namespace {

constexpr double kFarthest = 1e9;  // m, a million periods of the longest line

constexpr double kMostPeriods = 50;       // largest width of a view
constexpr double kLeastPeriods = 1e-9;    // smallest width of a view
constexpr double kFarthestPeriods = 1e6;  // largest distance from 0
/// Heights that would be exaggerated less than this many times are drawn to scale: so rough a
/// surface, such as a road, is seen as it is.
constexpr double kNearlyToScale = 5.5;
constexpr const char *kView = "--view", *kHeights = "--heights", *kColours = "--colours-to",
                     *kExaggeration = "--exaggeration", *kProbe = "--probe",
                     *kMagnify = "--magnify";

void checkPlace(const char* option, const std::optional<double>& place, double length) {
  if (place && !(std::abs(*place) <= kFarthestPeriods * length))
    throw InputError("", option,
                     message("{} m is not within {} m of 0", plainNumber(*place),
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
    const Clip plot = contactPlotArea(frame, options);
    const double size = fitted.width * plot.height / (plot.width * exaggeration);
    options.view.bottom = middle - 0.5 * size;
    options.view.top = middle + 0.5 * size;
  }
}

/// Returns how many times as large as lengths heights are drawn.
double exaggerationOf(const Frame& frame, const ContactPictureOptions& options) {
  const ContactView view = resolvedView(frame, options.view);
  const Clip plot = contactPlotArea(frame, options);
  return plot.height / (view.top - view.bottom) / (plot.width / view.width);
}

double& endOf(ContactView& view, ContactOverlay overlay) {
  if (overlay == ContactOverlay::Relaxation) return view.age;
  return overlay == ContactOverlay::Power ? view.power : view.pressure;
}

}  // namespace

const char* ViewArguments::firstOption() const {
  if (!xRange.empty()) return kView;
  if (!heights.empty()) return kHeights;
  if (exaggeration) return kExaggeration;
  if (coloursTo) return kColours;
  if (probe) return kProbe;
  return magnified ? kMagnify : nullptr;
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
                  "Heights to show, in m above the undeformed surface (default: all that occur)")
      ->type_name("FROM:TO");
  limit(
      command.add_option(kExaggeration, arguments.exaggeration,
                         "Draw heights this many times as large as lengths, instead of --heights"),
      1e-6, 1e12);
  limit(command.add_option(
            kColours, arguments.coloursTo,
            "Value at the bright end of the colours, in N/m, s or W/m (default: automatic)"),
        1e-300, 1e300);
  limit(command.add_option(kProbe, arguments.probe,
                           "Show a crosshair with readings at this position"),
        -kFarthest, kFarthest, "m");
  limit(
      command.add_option(kMagnify, arguments.magnified, "Show a magnified inset of this position"),
      -kFarthest, kFarthest, "m");
}

void checkView(const ViewArguments& arguments, ContactOverlay overlay, double length) {
  if (!arguments.xRange.empty()) {
    const NumberRange range = rangeFrom(kView, arguments.xRange, "m");
    const double width = arguments.width();
    if (width > kMostPeriods * length || width < kLeastPeriods * length)
      throw InputError(
          "", kView,
          message("{} is not {} wide, of which the most are {} periods of the line",
                  shortened(arguments.xRange),
                  rangeText(kLeastPeriods * length, kMostPeriods * length, "m"), kMostPeriods));
    checkPlace(kView, range.from, length);
  }
  if (!arguments.heights.empty()) rangeFrom(kHeights, arguments.heights, "m");
  if (!arguments.heights.empty() && arguments.exaggeration)
    throw InputError("", kExaggeration, "and --heights both say the heights; one is enough");
  if (arguments.coloursTo && overlay == ContactOverlay::None)
    throw InputError("", kColours, "there are no colours with --overlay none");
  checkPlace(kProbe, arguments.probe, length);
  checkPlace(kMagnify, arguments.magnified, length);
}

void applyView(const ViewArguments& arguments, const Frame& frame, ContactPictureOptions& options) {
  ContactView& view = options.view;
  if (!arguments.xRange.empty()) {
    const NumberRange range = rangeFrom(kView, arguments.xRange, "m");
    view.left = range.from;
    view.width = arguments.width();
  }
  if (arguments.coloursTo) endOf(view, options.overlay) = *arguments.coloursTo;
  options.probe = arguments.probe;
  if (arguments.magnified) options.magnifier = Magnifier{*arguments.magnified};
  if (!arguments.heights.empty()) {
    const NumberRange range = rangeFrom(kHeights, arguments.heights, "m");
    view.bottom = range.from;
    view.top = range.to;
  } else if (arguments.exaggeration) {
    exaggerate(*arguments.exaggeration, frame, options);
  } else if (arguments.xRange.empty()) {
    const double natural = exaggerationOf(frame, options);
    if (natural > 1 && natural <= kNearlyToScale) exaggerate(1, frame, options);
  }
}

}  // namespace asperity
