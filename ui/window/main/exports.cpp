#include "ui/window/main/exports.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <utility>

#include "ui/chart/chart_view.h"
#include "ui/contact/contact_overlay.h"
#include "ui/draw/fonts.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/translated.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/export/export_dialog.h"
#include "ui/window/export/export_form.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

// ---- Pictures

namespace {

QString copiedText() {
  return Exports::tr("The picture is on the clipboard");
}

QSize devicePixels(const QWidget& widget) {
  return widget.size() * widget.devicePixelRatioF();
}

void writeContact(const QString& file, const ContactShot& shot) {
  const Scene& scene = *shot.frame->scene;
  writePicture(
      file.toStdString(), composeContact(*shot.frame, shot.options),
      {sceneText(scene.title).toStdString(), pictureOrigin("render", scene), shot.options.scale});
}

}  // namespace

std::shared_ptr<const Frame> stillCopy(const Frame& frame) {
  const auto still = std::make_shared<Frame>(frame);
  still->timeScale = 0;
  return still;
}

Exports::Exports(const ExportParts& parts) : QObject(&parts.window), parts_(parts) {
  connect(&parts_.tabs, &SceneTabs::saved, this, &Exports::showSaved);
  connect(&parts_.tabs, &SceneTabs::copied, this, [this] { showSuccess(copiedText); });
  connect(&parts_.tabs, &SceneTabs::failed, this, &Exports::showFailure);
}

void Exports::addTo(Commands& commands) {
  commands.add({"copyPicture",
                [] { return tr("Copy picture"); },
                [this] { copyPicture(); },
                {QKeySequence::Copy}});
  commands.add({"savePicture",
                [] { return tr("Save picture as shown…"); },
                [this] { askPicture(); },
                {Qt::CTRL | Qt::Key_E}});
  commands.add({"exportPicture",
                [] { return tr("Export picture with options…"); },
                [this] { openDialog(ExportKind::Picture); },
                {Qt::CTRL | Qt::SHIFT | Qt::Key_P}});
  commands.setTip("savePicture", [] {
    return tr(
        "Saves the contact, or the figure that is shown instead, in the size and the colours "
        "that it has in the window");
  });
  commands.setTip("exportPicture", [] {
    return tr(
        "Opens a dialog with a preview: size, style, what stands below the contact, and the "
        "command line that makes the same picture");
  });
  commands.add(
      {"exportFilm", [] { return tr("Export film…"); }, [this] { openDialog(ExportKind::Film); }});
  commands.add({"exportTable", [] { return tr("Export table…"); },
                [this] { openDialog(ExportKind::Table); }});
  commands.add({"exportFigure", [] { return tr("Export figures of the paper…"); },
                [this] { openDialog(ExportKind::Figure); }});
  commands.add({"copyCommand",
                [] { return tr("Copy as command line"); },
                [this] { copyText(pictureCommand()); },
                {Qt::CTRL | Qt::SHIFT | Qt::Key_C}});
  commands.add(
      {"copyCurveCommand", [] { return tr("Copy the curve's command line"); },
       [this] {
         copyText(curveCommand(parts_.document.origin(), parts_.document.scene(), shownCurves()));
       }});
  const auto show = [this, &commands] { enableCommands(commands); };
  connect(&parts_.pages, &WindowPages::pageChanged, this, show);
  connect(&parts_.pages, &WindowPages::figureShown, this, show);
  connect(&parts_.session, &Session::plotChanged, this, show);
}

/// Enables the commands for what is visible: the contact, or the figure that is shown instead.
/// While a lesson hides the curve, pictures and tables that could have it are not made.
void Exports::enableCommands(Commands& commands) const {
  const bool hasViews = parts_.pages.isShowingViews();
  const bool hasFigure = parts_.pages.isShowingFigures() && parts_.pages.figuresPage().hasFigure();
  for (QAction* action : commands.get({"copyPicture", "savePicture"}))
    action->setEnabled(hasViews || hasFigure);
  const bool isConcealed = parts_.session.friction().isConcealed();
  for (QAction* action : commands.get({"copyCommand", "copyCurveCommand"}))
    action->setEnabled(hasViews);
  for (QAction* action : commands.get({"exportPicture", "exportFilm", "exportTable"}))
    action->setEnabled(hasViews && !isConcealed);
}

/// Returns the present picture as a still; nothing before the first frame.
std::optional<ContactShot> Exports::shot() const {
  const ContactCanvas& canvas = parts_.canvas;
  const std::shared_ptr<const Frame> frame = canvas.viewer().frame();
  if (!frame) return std::nullopt;
  ContactShot shot{stillCopy(*frame), {}};
  shot.options = canvas.viewer().options();
  const QSize size = devicePixels(canvas);
  shot.options.width = size.width();
  shot.options.height = size.height();
  shot.options.scale = static_cast<float>(canvas.devicePixelRatioF() * canvas.textScale());
  shot.options.fontSize = canvas.fontSize();
  shot.options.theme = parts_.appearance.theme();
  return shot;
}

/// Returns whether there is a contact to draw; otherwise the message bar gives the reason.
bool Exports::hasPicture() const {
  if (parts_.canvas.frame()) return true;
  showFailure(
      [] { return tr("There is no picture of the contact: this scene has not been computed."); });
  return false;
}

/// Shows that an export has succeeded, after which the failure of another one is over.
void Exports::showSuccess(const LiveText& text) {
  parts_.messages.end(MessageBar::Failure::Export);
  parts_.status.showMessage(text);
}

void Exports::showSaved(const QString& file) {
  showSuccess([file] { return savedText(file); });
}

void Exports::showFailure(const LiveText& reason) const {
  parts_.messages.showFailure(MessageBar::Failure::Export, reason);
}

void Exports::save(const QString& file, std::function<void()> write) {
  work_.request([write = std::move(write)](const BackgroundWork::Run&) { write(); },
                [this, file] { showSaved(file); },
                [this](const LiveText& reason) { showFailure(reason); });
}

void Exports::copy(std::function<QImage()> draw, const LiveText& copied) {
  work_.request([draw = std::move(draw)](const BackgroundWork::Run&) { return draw(); },
                [this, copied](const QImage& image) {
                  QGuiApplication::clipboard()->setImage(image);
                  showSuccess(copied);
                },
                [this](const LiveText& reason) { showFailure(reason); });
}

void Exports::copyPicture() {
  if (parts_.pages.isShowingFigures()) return parts_.pages.figuresPage().copyPicture();
  if (!hasPicture()) return;
  copy(
      [shot = *shot()] {
        return renderImage(contextOfThread(), composeContact(*shot.frame, shot.options));
      },
      copiedText);
}

void Exports::askPicture() {
  if (parts_.pages.isShowingFigures()) return parts_.pages.figuresPage().askPicture();
  if (!hasPicture()) return;
  const QString file = askPictureFile(&parts_.window, "contact.png");
  if (!file.isEmpty()) savePicture(file);
}

void Exports::savePicture(const QString& file) {
  if (!hasPicture()) return;
  save(file, [shot = *shot(), file] { writeContact(file, shot); });
}

CurveCommandOptions Exports::shownCurves() const {
  return {curves_->shown(), parts_.tabs.accuracy().comparison()};
}

/// Returns the options of a command that draws the contact and, below it, the front tab as they are
/// shown.
RenderCommandOptions Exports::shownOptions() const {
  const ContactCanvas& canvas = parts_.canvas;
  const Scene& scene = parts_.document.scene();
  RenderCommandOptions options;
  options.size = devicePixels(canvas);
  options.curves = shownCurves();
  if (parts_.tabs.currentWidget() == &parts_.tabs.plot()) {
    options.layout = QStringLiteral("both");
    options.below = devicePixels(parts_.tabs.plot()).height();
    options.hasCurves = true;
  } else if (parts_.tabs.isShowingMotion() && scene.sliding.kind != SlidingKind::Steady) {
    options.layout = QStringLiteral("transient");
  }
  options.scale = canvas.devicePixelRatioF() * canvas.textScale();
  options.dark = parts_.appearance.isDark();
  options.overlay = fromUtf8(choiceWord(kContactOverlays, canvas.viewer().overlay()));
  const std::optional<ContactShot> present = shot();
  // A frame of the previous scene has not yet been replaced; fitted values are then sufficient.
  if (present && present->frame->sceneNumber == parts_.session.sceneNumber()) {
    options.frame = present->frame;
    options.options = present->options;
  }
  return options;
}

QString Exports::pictureCommand() const {
  return renderCommand(parts_.document.origin(), parts_.document.scene(), shownOptions());
}

ExportDialog& Exports::openDialog(ExportKind kind) {
  delete parts_.window.findChild<ExportDialog*>(QString(), Qt::FindDirectChildrenOnly);
  const QString name = QFileInfo(parts_.document.fileOrProposal()).completeBaseName();
  auto* dialog =
      new ExportDialog({parts_.document.origin(), parts_.document.scene(), shownOptions(), name},
                       kind, program_, &parts_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (kind == ExportKind::Figure && parts_.pages.isShowingFigures())
    dialog->form().setContent(fromUtf8(figureEntry(parts_.pages.figuresPage().chosen()).word));
  connect(dialog, &ExportDialog::exported, this, &Exports::showSaved);
  dialog->open();
  return *dialog;
}

void Exports::copyText(const QString& text) {
  QGuiApplication::clipboard()->setText(text);
  parts_.status.showMessage(tr("On the clipboard: %1").arg(text.section(' ', 0, 2) + " …"));
}

}  // namespace asperity
