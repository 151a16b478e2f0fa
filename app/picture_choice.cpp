#include "app/picture_choice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/named_choice.h"
#include "app/output.h"
#include "core/base/input_error.h"
#include "core/base/read_number.h"
#include "ui/draw/picture_origin.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr int kSmallest = 160, kLargest = 16384;  // pixels
constexpr double kPixelsPerInch = 96;

void readSize(const std::string& text, PictureStyle& style) {
  const std::size_t cross = text.find('x');
  const std::string_view all = text;
  const bool good = cross != std::string::npos && readNumber(all.substr(0, cross), style.width) &&
                    readNumber(all.substr(cross + 1), style.height);
  const auto fits = [](int pixels) { return pixels >= kSmallest && pixels <= kLargest; };
  if (!good || !fits(style.width) || !fits(style.height))
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

nlohmann::ordered_json PictureStyle::json() const {
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

void checkUseful(const PictureChoice& choice, const std::vector<std::string>& files) {
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
    for (const auto& [option, given] : {std::pair{"--size", !choice.size.empty()},
                                        {"--scale", !choice.scale.empty()},
                                        {"--theme", !choice.theme.empty()},
                                        {"--transparent", choice.transparent},
                                        {"--backend", !choice.backend.empty()}})
      refuse(option, given, "belongs to pictures, and no output is one");
  if (!hasPixels)
    refuse("--backend", !choice.backend.empty(),
           "draws pixels; .svg and .pdf are written without them");
}

void addPictureOptions(CLI::App& verb, PictureChoice& choice, const std::string& defaultSize,
                       const std::string& defaultTheme) {
  verb.add_option("--size", choice.size,
                  "Width and height in pixels; else " + defaultSize + " times the scale")
      ->type_name("WxH");
  verb.add_option("--scale", choice.scale,
                  "Density: 2 doubles texts and line widths; or 300dpi; else 1, which is 96dpi");
  verb.add_option("--theme", choice.theme, "light, dark or print; else " + defaultTheme);
  verb.add_flag("--transparent", choice.transparent, "No background");
  verb.add_option("--backend", choice.backend,
                  "What draws: osmesa, egl, or auto: the first that is there; else auto");
}

PictureStyle styleOf(const PictureChoice& choice, const PictureDefaults& defaults) {
  PictureStyle style;
  if (!choice.scale.empty()) style.scale = scaleFrom(choice.scale);
  style.width = static_cast<int>(std::lround(static_cast<float>(defaults.width) * style.scale));
  style.height = static_cast<int>(std::lround(static_cast<float>(defaults.height) * style.scale));
  readSize(choice.size.empty() ? fmt::format("{}x{}", style.width, style.height) : choice.size,
           style);
  style.themeName = choice.theme.empty() ? defaults.theme : choice.theme;
  style.theme = chosenFrom(kThemes, style.themeName, "--theme")();
  style.transparent = choice.transparent;
  if (!choice.backend.empty()) style.backend = chosenFrom(kBackends, choice.backend, "--backend");
  return style;
}

}  // namespace asperity
