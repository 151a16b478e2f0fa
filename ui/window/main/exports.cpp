#include "ui/window/main/exports.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/material/material_library.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"
#include "ui/chart/chart_view.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/stroke_pattern.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/figure_pages.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"

namespace asperity {

// ---- Calls of `asperity`

namespace {

/// Returns the scene with absolute paths to its files, which are found from any folder.
Scene withAbsoluteProfile(Scene scene) {
  const auto absolute = [&](const std::string& name) {
    return std::filesystem::absolute(scene.folder / name).lexically_normal().string();
  };
  if (hasSurfaceFile(scene.surface)) scene.surface.file = absolute(scene.surface.file);
  if (!scene.elastomer.material.empty() &&
      !materialFile(scene.elastomer.material, scene.folder).empty())
    scene.elastomer.material = absolute(scene.elastomer.material);
  return scene;
}

std::vector<std::string> assignmentsOver(const SceneOrigin& origin, const Scene& scene) {
  const bool sameFolder = !origin.file.isEmpty() && origin.scene.folder == scene.folder;
  return assignmentsFrom(origin.scene, sameFolder ? scene : withAbsoluteProfile(scene));
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

constexpr double kUnseen = 1e-5;  // part of a view's width, less than a pixel

/// Rounds a position (m) to the digits that can be seen in a view of this width (m).
double seen(double position, double width) {
  const double grid = std::pow(10, std::floor(std::log10(kUnseen * width)));
  const double rounded = std::round(position / grid) * grid;
  if (!std::isfinite(rounded) || rounded == 0) return std::isfinite(position) ? 0 : position;
  const double digits = std::floor(std::log10(std::abs(rounded))) - std::log10(grid) + 1.5;
  return roundedToDigits(rounded, static_cast<int>(std::clamp(digits, 1.0, 17.0)));
}

/// Rounds the place of the crosshair to its element, with digits that tell it from its neighbours.
double probed(double position, const Frame& frame, double width) {
  if (!(frame.spacing > 0)) return seen(position, width);
  const double element = std::round(position / frame.spacing) * frame.spacing;
  return seen(element, std::min(width, 0.1 * frame.spacing / kUnseen));
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

/// Returns the scene of a pinned curve as assignments to the present one.
QString pinnedText(Scene pinned, const Scene& scene) {
  if (pinned.folder != scene.folder) pinned = withAbsoluteProfile(pinned);
  pinned.title = scene.title;
  pinned.description = scene.description;
  pinned.chapter = scene.chapter;
  pinned.sliding = scene.sliding;
  return QString::fromStdString(joinedAssignments(assignmentsFrom(scene, pinned)));
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
  if (!options.curves.compared) return static_cast<int>(std::lround(contact / kContactPart));
  return std::max(static_cast<int>(std::lround(contact / kContactPartOfThree)),
                  contact + options.below);
}

QString command(const QStringList& words) {
  QStringList quoted;
  for (const QString& word : words) quoted += shellQuoted(word);
  return quoted.join(' ');
}

}  // namespace

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
  return command(words);
}

QString curveCommand(const SceneOrigin& origin, const Scene& scene,
                     const CurveCommandOptions& curves) {
  QStringList words = QStringList{"asperity", "curve"} + sceneWords(origin, scene);
  words += {"-o", "curve.csv"};
  const QStringList more = curveWords(curves, scene);
  const auto isAxis = [&](const char* option) { return more.contains(QLatin1String(option)); };
  // Only pictures have axes.
  if (isAxis("--axes") || isAxis("--x-range") || isAxis("--y-range")) words += {"-o", "curve.png"};
  return command(words + more);
}

QString shellQuoted(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_@%+=:,./-]+$"));
  if (plain.match(word).hasMatch()) return word;
  QString inside = word;
  return '\'' + inside.replace('\'', QStringLiteral("'\\''")) + '\'';
}

// ---- Pictures

namespace {

QSize devicePixels(const QWidget& widget) {
  return widget.size() * widget.devicePixelRatioF();
}

}  // namespace

Exports::Exports(const ExportParts& parts) : QObject(&parts.window), parts_(parts) {}

void Exports::addTo(Commands& commands) {
  commands.add({"copyPicture",
                [] { return tr("Copy picture"); },
                [this] { copyPicture(); },
                {QKeySequence::Copy}});
  commands.add({"savePicture",
                [] { return tr("Save picture…"); },
                [this] { askPicture(); },
                {Qt::CTRL | Qt::Key_E}});
  commands.add({"copyCommand",
                [] { return tr("Copy as command line"); },
                [this] { copyText(pictureCommand()); },
                {Qt::CTRL | Qt::SHIFT | Qt::Key_C}});
  commands.add(
      {"copyCurveCommand", [] { return tr("Copy the curve's command line"); },
       [this] {
         copyText(curveCommand(parts_.document.origin(), parts_.document.scene(), shownCurves()));
       }});
  const auto show = [this, &commands] { showCommands(commands); };
  connect(&parts_.figures, &FigurePages::switched, this, show);
  connect(&parts_.figures, &FigurePages::figureShown, this, show);
}

/// Shows the commands for what is visible: the contact, or the figure that is shown instead.
void Exports::showCommands(Commands& commands) const {
  const bool figures = parts_.figures.isShowingFigures();
  for (QAction* action : commands.get({"copyPicture", "savePicture"}))
    action->setEnabled(!figures || parts_.figures.gallery().hasFigure());
  for (QAction* action : commands.get({"copyCommand", "copyCurveCommand"}))
    action->setEnabled(!figures);
}

/// Returns the present picture as a still; none before the first.
std::optional<ContactShot> Exports::shot() const {
  const ContactCanvas& canvas = parts_.canvas;
  const std::shared_ptr<const Frame> frame = canvas.viewer().frame();
  if (!frame) return std::nullopt;
  ContactShot shot{stillOf(*frame), {}};
  shot.options = canvas.viewer().options();
  const QSize size = devicePixels(canvas);
  shot.options.width = size.width();
  shot.options.height = size.height();
  shot.options.scale = static_cast<float>(canvas.devicePixelRatioF() * canvas.textScale());
  shot.options.theme = parts_.appearance.theme();
  return shot;
}

/// Draws in the background, so that the window goes on meanwhile.
void Exports::run(std::function<void()> work, std::function<void()> done) {
  work_.request([work = std::move(work)](const BackgroundWork::Run&) { work(); },
                [this, done = std::move(done)] {
                  parts_.messages.end(MessageBar::Failure::Export);
                  done();
                },
                [this](const QString& reason) {
                  parts_.messages.showFailure(MessageBar::Failure::Export, reason);
                });
}

void Exports::copyPicture() {
  if (parts_.figures.isShowingFigures()) return parts_.figures.gallery().copyPicture();
  const std::optional<ContactShot> present = shot();
  if (!present) return;
  const auto image = std::make_shared<QImage>();
  run([shot = *present, image] { *image = imageOf(shot); },
      [this, image] {
        QGuiApplication::clipboard()->setImage(*image);
        parts_.status.say(tr("The picture is on the clipboard"));
        emit exported({});
      });
}

void Exports::askPicture() {
  if (parts_.figures.isShowingFigures()) return parts_.figures.gallery().askPicture();
  const QString file = askSaveFile(&parts_.window, tr("Save picture"), "contact.png",
                                   tr("Pictures (*.png *.svg *.pdf)"));
  if (!file.isEmpty()) savePicture(file);
}

void Exports::savePicture(const QString& file) {
  const std::optional<ContactShot> present = shot();
  if (!present) return;
  run([shot = *present, file] { writeContact(file.toStdString(), shot); },
      [this, file] {
        parts_.status.say(tr("Saved %1").arg(QFileInfo(file).fileName()));
        emit exported(file);
      });
}

CurveCommandOptions Exports::shownCurves() const {
  return {curves_->shown(), parts_.tabs.accuracy().comparison()};
}

/// Returns the call that draws the contact and, below it, the front tab.
QString Exports::pictureCommand() const {
  const ContactCanvas& canvas = parts_.canvas;
  const Scene& scene = parts_.document.scene();
  RenderCommandOptions options;
  options.size = devicePixels(canvas);
  if (parts_.tabs.currentWidget() == &parts_.tabs.plot()) {
    options.layout = QStringLiteral("both");
    options.below = devicePixels(parts_.tabs.plot()).height();
    options.hasCurves = true;
    options.curves = shownCurves();
  } else if (parts_.tabs.isShowingMotion() && scene.sliding.kind != SlidingKind::Steady) {
    options.layout = QStringLiteral("transient");
  }
  options.scale = canvas.devicePixelRatioF() * canvas.textScale();
  options.dark = parts_.appearance.isDark();
  options.overlay = QString::fromUtf8(wordFor(canvas.viewer().overlay()).data());
  const std::optional<ContactShot> present = shot();
  // A frame of the previous scene has not yet been replaced; fitted values are then sufficient.
  if (present && present->frame->sceneNumber == parts_.session.sceneNumber()) {
    options.frame = present->frame;
    options.options = present->options;
  }
  return renderCommand(parts_.document.origin(), scene, options);
}

void Exports::copyText(const QString& text) {
  QGuiApplication::clipboard()->setText(text);
  parts_.status.say(tr("On the clipboard: %1").arg(text.section(' ', 0, 2) + " …"));
}

}  // namespace asperity
