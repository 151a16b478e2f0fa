#include "ui/window/export/asperity_command.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/chart/curve_diagram.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_assignments.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_files.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_picture.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

/// Returns the scene with its files named as in the file of its origin.
Scene withFilesOf(const SceneOrigin& origin, const Scene& scene) {
  const std::filesystem::path file(origin.file.toStdString());
  return withFilesRelativeTo(std::filesystem::absolute(file).parent_path(), scene);
}

std::vector<std::string> assignmentsOver(const SceneOrigin& origin, const Scene& scene) {
  if (origin.file.isEmpty()) return differingAssignments(origin.scene, withAbsoluteFiles(scene));
  return differingAssignments(withFilesOf(origin, origin.scene), withFilesOf(origin, scene));
}

/// Returns the shipped scene from which the fewest assignments lead to this one.
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

/// Returns whether the scene can still be read where it came from. A file may have been changed
/// since. It may name its files otherwise than the scene, which was perhaps saved from another
/// folder.
bool isAsRead(const SceneOrigin& origin) {
  if (origin.file.isEmpty()) return origin.isKnown();
  try {
    const Scene read = readSceneFile(origin.file.toStdString());
    return writeScene(withFilesOf(origin, read)) == writeScene(withFilesOf(origin, origin.scene));
  } catch (const std::exception&) {
    return false;
  }
}

QStringList sceneWords(const SceneOrigin& known, const Scene& scene) {
  const SceneOrigin origin = isAsRead(known) ? known : nearestShipped(scene);
  QStringList words{origin.file.isEmpty() ? origin.shipped + ".json"
                                          : QFileInfo(origin.file).absoluteFilePath()};
  for (const std::string& assignment : assignmentsOver(origin, scene))
    words += {QStringLiteral("--set"), QString::fromStdString(assignment)};
  return words;
}

QString range(double from, double to) {
  return numberText(from) + ':' + numberText(to);
}

constexpr double kSubpixel = 1e-5;  // part of a view's width, less than a pixel

/// Rounds a position (m) to the digits that are visible in a view of this width (m).
double seen(double position, double width) {
  const double grid = std::pow(10, std::floor(std::log10(kSubpixel * width)));
  const double rounded = std::round(position / grid) * grid;
  if (!std::isfinite(rounded) || rounded == 0) return std::isfinite(position) ? 0 : position;
  const double digits = std::floor(std::log10(std::abs(rounded))) - std::log10(grid) + 1.5;
  return roundedToDigits(rounded, static_cast<int>(std::clamp(digits, 1.0, 17.0)));
}

/// Rounds the position of the crosshair to its element, with enough digits to distinguish it from
/// its neighbours.
double probed(double position, const Frame& frame, double width) {
  if (!(frame.spacing > 0)) return seen(position, width);
  const double element = std::round(position / frame.spacing) * frame.spacing;
  return seen(element, std::min(width, 0.1 * frame.spacing / kSubpixel));
}

/// Returns the options of the view. They always contain the heights and the maximum of the colour
/// scale, because fitted ones would be those of the first frame.
QStringList viewWords(const RenderCommandOptions& options) {
  const Frame& frame = *options.frame;
  const ContactPictureOptions& picture = options.options;
  const ContactView view = resolvedView(frame, picture.view);
  const double width = view.width;
  QStringList words;
  if (view.left != 0 || std::abs(width - frame.length) > 1e-9 * frame.length)
    words += {"--view", range(seen(view.left, width), seen(view.left + width, width))};
  const double size = view.top - view.bottom;
  words += {"--heights", range(seen(view.bottom, size), seen(view.top, size))};
  if (const double end = colourMaximum(view, picture.overlay); end > 0)
    words += {"--colours-to", numberText(roundedToDigits(end, 6))};
  if (picture.probe) words += {"--probe", numberText(probed(*picture.probe, frame, width))};
  if (picture.magnifier)
    // The magnified part is some ten times narrower than the view, and lines are antialiased.
    words += {"--magnify", numberText(seen(picture.magnifier->position, 1e-5 * width))};
  return words;
}

/// Returns the time of the frame (s) with as few digits as distinguish it from the next step: a
/// call takes whole steps that do not go beyond this time.
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

/// Returns the option of the time: the time of a motion, or the distance of steady sliding.
QStringList momentWords(const RenderCommandOptions& options) {
  const Frame& frame = *options.frame;
  if (frame.transient) return {"--at", numberText(moment(frame))};
  QStringList words;
  const double width = resolvedView(frame, options.options.view).width;
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

/// Returns the scene of a pinned curve as assignments to the present one. Files that differ have
/// absolute names, because the call reads the scene in the folder of its file.
QString pinnedText(const Scene& curve, const Scene& present) {
  Scene pinned = withAbsoluteFiles(curve);
  const Scene scene = withAbsoluteFiles(present);
  pinned.title = scene.title;
  pinned.description = scene.description;
  pinned.chapter = scene.chapter;
  pinned.sliding = scene.sliding;
  return QString::fromStdString(joinedAssignments(differingAssignments(scene, pinned)));
}

/// Returns the options of the curves that are compared, and of the axes.
QStringList curveWords(const CurveCommandOptions& options, const Scene& scene) {
  QStringList words;
  if (options.compared) words += {"--compare", settingText(*options.compared)};
  if (!options.shown) return words;
  const CurveSet& curves = *options.shown;
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

/// Returns a height (pixels) at which the contact is as high as in the window; with a comparison,
/// for which the window makes the contact low, the picture is as high as all visible parts.
int pictureHeight(const RenderCommandOptions& options) {
  const int contact = options.size.height();
  if (options.layout == "contact") return contact;
  const double part = options.curves.compared ? kContactPartOfThree : kContactPart;
  int height = static_cast<int>(std::lround(contact / part));
  if (options.curves.compared) height = std::max(height, contact + options.below);
  if (options.layout != "both") return height;
  const int left = static_cast<int>(height * (1 - part));
  const int chart = curveHeight(options.curves, {options.size.width(), left}, options.scale);
  return std::max(height, chart > left ? static_cast<int>(std::ceil(chart / (1 - part))) : 0);
}

}  // namespace

int curveHeight(const CurveCommandOptions& curves, QSize size, double scale) {
  constexpr double kSpare = 1.03;  // letters of a preview are rounded to other pixels
  if (!curves.shown || size.isEmpty()) return size.height();
  CurveSet set = *curves.shown;
  // The command computes the difference even where the window has not finished it.
  if (curves.compared && !set.difference) set.difference.emplace().setting = *curves.compared;
  const DiagramSheet sheet = curveSheet(set);
  if (sheet.diagrams.size() < 2) return size.height();
  DiagramOptions options;
  options.width = size.width();
  options.height = static_cast<int>(size.height() / kSpare);
  options.scale = static_cast<float>(scale);
  const int needed = heightForAll(sheet, options);
  return std::max(size.height(), static_cast<int>(std::ceil(kSpare * needed)));
}

QString commandText(const QStringList& words) {
  QStringList quoted;
  for (const QString& word : words) quoted += shellQuoted(word);
  return quoted.join(' ');
}

QSize renderSize(const RenderCommandOptions& options, const QString& layout) {
  RenderCommandOptions same = options;
  same.layout = layout;
  return {options.size.width(), pictureHeight(same)};
}

QString renderCommand(const SceneOrigin& origin, const Scene& scene,
                      const RenderCommandOptions& options) {
  QStringList words{"asperity", "render"};
  words += sceneWords(origin, scene);
  words += {"-o", "picture.png"};
  if (options.layout != "contact") words += {"--layout", options.layout};
  if (!options.size.isEmpty()) {
    words +=
        {"--size", QStringLiteral("%1x%2").arg(options.size.width()).arg(pictureHeight(options))};
  }
  if (options.scale != 1) words += {"--scale", numberText(options.scale)};
  if (options.dark) words += {"--theme", "dark"};
  if (options.overlay != "pressure") words += {"--overlay", options.overlay};
  if (options.frame) words += momentWords(options) + viewWords(options);
  if (options.hasCurves) words += curveWords(options.curves, scene);
  if (presentLanguage() != "en") words += {"--language", fromUtf8(presentLanguage())};
  return commandText(words);
}

QString curveCommand(const SceneOrigin& origin, const Scene& scene,
                     const CurveCommandOptions& curves) {
  QStringList words = QStringList{"asperity", "curve"} + sceneWords(origin, scene);
  words += {"-o", "curve.csv"};
  const QStringList more = curveWords(curves, scene);
  const auto isAxis = [&](const char* option) { return more.contains(QLatin1String(option)); };
  // Only pictures have axes.
  if (isAxis("--axes") || isAxis("--x-range") || isAxis("--y-range")) words += {"-o", "curve.png"};
  return commandText(words + more);
}

namespace {

void add(QStringList& words, const char* option, const QString& value) {
  if (!value.isEmpty()) words += {QLatin1String(option), value};
}

/// Returns the options of the curves without those of axes, which only pictures have.
QStringList withoutAxes(const QStringList& words) {
  QStringList rest;
  for (int i = 0; i + 1 < words.size(); i += 2)
    if (words[i] != "--axes" && words[i] != "--x-range" && words[i] != "--y-range")
      rest += words.mid(i, 2);
  return rest;
}

/// Returns the options of the contact: its colours, its part, its moment.
QStringList contactWords(const ExportRequest& request, const RenderCommandOptions& shown) {
  QStringList words;
  const bool isTable = request.kind == ExportKind::Table;
  if (isTable) words += {"--table", request.content};
  if (!isTable && request.content != "contact") words += {"--layout", request.content};
  if (!isTable && shown.overlay != "pressure") words += {"--overlay", shown.overlay};
  if (!request.asShown || !shown.frame) return words;
  if (request.kind != ExportKind::Film) words += momentWords(shown);
  if (!isTable) words += viewWords(shown);
  return words;
}

}  // namespace

QStringList exportWords(const SceneOrigin& origin, const Scene& scene, const ExportRequest& request,
                        const RenderCommandOptions& shown, const QString& file) {
  QStringList words{"asperity"};
  if (request.kind == ExportKind::Figure) {
    words += {"figure", request.content, "-o", file};
    add(words, "--realizations", request.realizations);
  } else {
    const bool isOfContact = request.content != "curve" && request.content != "motion";
    words += isOfContact ? QStringLiteral("render") : request.content;
    words += sceneWords(origin, scene);
    words += {"-o", file};
    if (isOfContact) words += contactWords(request, shown);
    if (request.content == "curve" || request.content == "both") {
      const QStringList curves = curveWords(shown.curves, scene);
      words += request.kind == ExportKind::Table ? withoutAxes(curves) : curves;
    }
  }
  if (request.kind == ExportKind::Table) {
    add(words, "--columns", request.columns);
  } else {
    add(words, "--style", request.style);
    add(words, "--size", request.size);
    add(words, "--scale", request.scale);
    add(words, "--theme", request.theme);
    if (request.isTransparent) words += "--transparent";
  }
  if (request.kind == ExportKind::Film) {
    add(words, "--duration", request.duration);
    add(words, "--fps", request.framesPerSecond);
    add(words, "--cycles", request.cycles);
    add(words, "--slow-motion", request.slowMotion);
  }
  if (presentLanguage() != "en") words += {"--language", fromUtf8(presentLanguage())};
  return words + request.further;
}

QString shellQuoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inside = word;
  return '\'' + inside.replace('\'', QStringLiteral("'\\''")) + '\'';
}

}  // namespace asperity
