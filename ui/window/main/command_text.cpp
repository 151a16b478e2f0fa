#include "ui/window/main/command_text.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"
#include "core/scene/parameters.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/stroke_pattern.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

/// A profile is found wherever the command is given.
Scene withAbsoluteProfile(Scene scene) {
  if (scene.surface.kind == SurfaceKind::Profile)
    scene.surface.file =
        std::filesystem::absolute(scene.folder / scene.surface.file).lexically_normal().string();
  return scene;
}

std::vector<std::string> assignmentsOver(const SceneOrigin& origin, const Scene& scene) {
  const bool sameFolder = !origin.file.isEmpty() && origin.scene.folder == scene.folder;
  return assignmentsFrom(origin.scene, sameFolder ? scene : withAbsoluteProfile(scene));
}

/// Of the shipped scenes the one that needs the fewest words.
SceneOrigin nearestShipped(const Scene& scene) {
  SceneOrigin nearest;
  std::optional<std::size_t> fewest;
  for (const LibraryScene& entry : libraryScenes()) {
    const SceneOrigin origin{entry.name, {}, entry.scene};
    const std::size_t count = assignmentsOver(origin, scene).size();
    if (fewest && *fewest <= count) continue;
    fewest = count;
    nearest = origin;
  }
  return nearest;
}

QStringList sceneWords(const SceneOrigin& known, const Scene& scene) {
  const SceneOrigin origin = known.isKnown() ? known : nearestShipped(scene);
  QStringList words{origin.file.isEmpty() ? origin.shipped + ".json"
                                          : QFileInfo(origin.file).absoluteFilePath()};
  for (const std::string& assignment : assignmentsOver(origin, scene))
    words += {QStringLiteral("--set"), QString::fromStdString(assignment)};
  return words;
}

QString range(double from, double to) {
  return numberText(from) + ':' + numberText(to);
}

constexpr double kUnseen = 1e-5;  // of a view's width, less than a pixel

/// With the digits that are seen where the view is so wide.
double seen(double position, double width) {
  const double grid = std::pow(10, std::floor(std::log10(kUnseen * width)));
  const double rounded = std::round(position / grid) * grid;
  if (!std::isfinite(rounded) || rounded == 0) return std::isfinite(position) ? 0 : position;
  const double digits = std::floor(std::log10(std::abs(rounded))) - std::log10(grid) + 1.5;
  return roundedToDigits(rounded, static_cast<int>(std::clamp(digits, 1.0, 17.0)));
}

/// Where the crosshair stands: at an element, which is told from its neighbours in any view.
double probed(double position, const Frame& frame, double width) {
  if (!(frame.spacing > 0)) return seen(position, width);
  const double element = std::round(position / frame.spacing) * frame.spacing;
  return seen(element, std::min(width, 0.1 * frame.spacing / kUnseen));
}

/// Where somebody looks. Heights and the end of the colours are always said: fitted ones would be
/// those of the first moment.
QStringList viewWords(const PictureWish& wish) {
  const Frame& frame = *wish.frame;
  const ContactPictureOptions& options = wish.options;
  const ContactView view = resolvedView(frame, options.view);
  const double width = view.width;
  QStringList words;
  if (view.left != 0 || std::abs(width - frame.length) > 1e-9 * frame.length)
    words += {"--view", range(seen(view.left, width), seen(view.left + width, width))};
  const double size = view.top - view.bottom;
  words += {"--heights", range(seen(view.bottom, size), seen(view.top, size))};
  if (const double end = endIn(view, options.overlay); end > 0)
    words += {"--colours-to", numberText(roundedToDigits(end, 6))};
  if (options.probe) words += {"--probe", numberText(probed(*options.probe, frame, width))};
  if (options.magnifier)
    words += {"--magnify", numberText(seen(options.magnifier->position, width))};
  return words;
}

/// With as few digits as tell it from the next step: a call takes whole steps that do not go beyond
/// its moment.
double moment(const Frame& frame) {
  constexpr int kAll = 17;
  for (int digits = 1; digits < kAll; ++digits) {
    double rounded = roundedToDigits(frame.time, digits);
    if (rounded < frame.time) {
      const double unit = std::pow(10, std::floor(std::log10(frame.time)) - digits + 1);
      rounded = roundedToDigits(frame.time + unit, digits);
    }
    if (rounded >= frame.time && rounded <= frame.time + 0.5 * frame.nextStep) return rounded;
  }
  return frame.time;
}

/// The moment: of a motion its time, which says all; of steady sliding how far the line has come.
QStringList momentWords(const PictureWish& wish) {
  const Frame& frame = *wish.frame;
  if (frame.transient) return {"--at", numberText(moment(frame))};
  QStringList words;
  const double width = resolvedView(frame, wish.options.view).width;
  if (frame.distance != 0) words += {"--slid", numberText(seen(frame.distance, width))};
  return words;
}

QString settingText(const CurveSetting& setting) {
  const auto& schemes = std::get<ChoiceField>(findParameter("accuracy.scheme")->field).choices;
  return QStringLiteral("%1:%2:%3")
      .arg(fromUtf8(schemes[static_cast<std::size_t>(setting.scheme)]))
      .arg(setting.oversampling)
      .arg(setting.realizations);
}

/// The scene of a pinned curve as keys set over the present one.
QString pinnedText(Scene pinned, const Scene& scene) {
  if (pinned.folder != scene.folder) pinned = withAbsoluteProfile(pinned);
  pinned.title = scene.title;
  pinned.description = scene.description;
  pinned.chapter = scene.chapter;
  pinned.sliding = scene.sliding;
  return QString::fromStdString(joinedAssignments(assignmentsFrom(scene, pinned)));
}

/// The curves that are compared, and the axes.
QStringList curveWords(const CurveWish& wish, const Scene& scene) {
  QStringList words;
  if (wish.compared) words += {"--compare", settingText(*wish.compared)};
  if (!wish.shown) return words;
  const CurveSet& curves = *wish.shown;
  if (curves.axes == CurveAxes::Dimensionless) words += {"--axes", "dimensionless"};
  if (curves.xFrom < curves.xTo)
    words += {"--x-range", range(roundedToDigits(curves.xFrom, 5), roundedToDigits(curves.xTo, 5))};
  if (curves.yFrom < curves.yTo)
    words += {"--y-range", range(roundedToDigits(curves.yFrom, 5), roundedToDigits(curves.yTo, 5))};
  for (const NamedCurve& pinned : curves.pinned)
    if (const QString text = pinnedText(pinned.scene, scene); !text.isEmpty())
      words += {"--with", text};
  return words;
}

/// The contact as high as in the window; with a comparison, for which the window makes it low, as
/// high as all that is seen.
int pictureHeight(const PictureWish& wish) {
  const int contact = wish.size.height();
  if (wish.layout == "contact") return contact;
  if (!wish.curves.compared) return static_cast<int>(std::lround(contact / kContactPart));
  return std::max(static_cast<int>(std::lround(contact / kContactPartOfThree)),
                  contact + wish.below);
}

QString command(const QStringList& words) {
  QStringList quoted;
  for (const QString& word : words) quoted += shellQuoted(word);
  return quoted.join(' ');
}

}  // namespace

QString renderCommand(const SceneOrigin& origin, const Scene& scene, const PictureWish& wish) {
  QStringList words{"asperity", "render"};
  words += sceneWords(origin, scene);
  words += {"-o", "picture.png"};
  if (wish.layout != "contact") words += {"--layout", wish.layout};
  if (!wish.size.isEmpty()) {
    words += {"--size", QStringLiteral("%1x%2").arg(wish.size.width()).arg(pictureHeight(wish))};
  }
  if (wish.scale != 1) words += {"--scale", numberText(wish.scale)};
  if (wish.dark) words += {"--theme", "dark"};
  if (wish.overlay != "pressure") words += {"--overlay", wish.overlay};
  if (wish.frame) words += momentWords(wish) + viewWords(wish);
  if (wish.hasCurves) words += curveWords(wish.curves, scene);
  if (presentLanguage() != "en") words += {"--language", fromUtf8(presentLanguage())};
  return command(words);
}

QString curveCommand(const SceneOrigin& origin, const Scene& scene, const CurveWish& curves) {
  QStringList words = QStringList{"asperity", "curve"} + sceneWords(origin, scene);
  words += {"-o", "curve.csv"};
  const QStringList more = curveWords(curves, scene);
  const auto isAxis = [&](const char* option) { return more.contains(QLatin1String(option)); };
  // Axes are a picture's.
  if (isAxis("--axes") || isAxis("--x-range") || isAxis("--y-range")) words += {"-o", "curve.png"};
  return command(words + more);
}

QString shellQuoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inside = word;
  return '\'' + inside.replace('\'', QStringLiteral("'\\''")) + '\'';
}

}  // namespace asperity
