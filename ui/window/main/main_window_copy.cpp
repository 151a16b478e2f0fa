// What leaves the main window: its picture, and the calls of `asperity` that make it without one.
#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QTabWidget>
#include <exception>
#include <memory>
#include <utility>

#include "ui/chart/chart_view.h"
#include "ui/language/translated.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/ask_file.h"
#include "ui/window/main/command_text.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"

namespace asperity {

namespace {

QSize devicePixels(const QWidget& widget) {
  return widget.size() * widget.devicePixelRatioF();
}

}  // namespace

void MainWindow::buildCopyCommands() {
  copyPicture_ = addCommand("copyPicture", tr("Copy picture"), QKeySequence::Copy, Symbol::None,
                            [this] { copyPicture(); });
  savePicture_ = addCommand("savePicture", tr("Save picture…"), Qt::CTRL | Qt::Key_E, Symbol::None,
                            [this] { askPicture(); });
  copyRender_ =
      addCommand("copyCommand", tr("Copy as command line"), Qt::CTRL | Qt::SHIFT | Qt::Key_C,
                 Symbol::None, [this] { copyText(pictureCommand()); });
  copyCurve_ = addCommand(
      "copyCurveCommand", tr("Copy the curve's command line"), {}, Symbol::None,
      [this] { copyText(curveCommand(document_->origin(), document_->scene(), shownCurves())); });
}

/// The picture that is on the screen, standing still; none before the first.
std::optional<ContactShot> MainWindow::shot() const {
  const std::shared_ptr<const Frame> frame = canvas_->viewer().frame();
  if (!frame) return std::nullopt;
  ContactShot shot{stillOf(*frame), {}};
  shot.options = canvas_->viewer().options();
  const QSize size = devicePixels(*canvas_);
  shot.options.width = size.width();
  shot.options.height = size.height();
  shot.options.scale = static_cast<float>(canvas_->devicePixelRatioF() * canvas_->textScale());
  shot.options.theme = dark_ ? darkTheme() : lightTheme();
  return shot;
}

/// Drawn beside the window: OSMesa must not come near its own context.
void MainWindow::runExport(std::function<void()> work, std::function<void()> done) {
  export_ = std::jthread([this, work = std::move(work), done = std::move(done)] {
    QString complaint;
    try {
      work();
    } catch (const std::exception& error) {
      complaint = translatedText(error.what());
    }
    QMetaObject::invokeMethod(this, [this, complaint, done] {
      if (!complaint.isEmpty())
        return messages_->showFailure(MessageBar::Failure::Export, complaint);
      endFailure(MessageBar::Failure::Export);
      done();
    });
  });
}

/// Of what is in sight: the contact, or the figure that is shown instead.
void MainWindow::showExports() {
  const bool figures = isShowingFigures();
  for (QAction* action : {copyPicture_, savePicture_})
    action->setEnabled(!figures || gallery_->hasFigure());
  for (QAction* action : {copyRender_, copyCurve_}) action->setEnabled(!figures);
}

void MainWindow::copyPicture() {
  if (isShowingFigures()) return gallery_->copyPicture();
  const std::optional<ContactShot> present = shot();
  if (!present) return;
  const auto image = std::make_shared<QImage>();
  runExport([shot = *present, image] { *image = imageOf(shot); },
            [this, image] {
              QGuiApplication::clipboard()->setImage(*image);
              status_->say(tr("The picture is on the clipboard"));
              emit exported({});
            });
}

void MainWindow::askPicture() {
  if (isShowingFigures()) return gallery_->askPicture();
  const QString file =
      askSaveFile(this, tr("Save picture"), "contact.png", tr("Pictures (*.png *.svg *.pdf)"));
  if (!file.isEmpty()) savePicture(file);
}

void MainWindow::savePicture(const QString& file) {
  const std::optional<ContactShot> present = shot();
  if (!present) return;
  runExport([shot = *present, file] { writeContact(file.toStdString(), shot); },
            [this, file] {
              status_->say(tr("Saved %1").arg(QFileInfo(file).fileName()));
              emit exported(file);
            });
}

CurveWish MainWindow::shownCurves() const {
  return {curveCommands_->shown(), accuracy_->comparison()};
}

/// The contact with what is in front under it.
QString MainWindow::pictureCommand() const {
  PictureWish wish;
  const QWidget* front = tabs_->currentWidget();
  wish.size = devicePixels(*canvas_);
  if (front == plot_) {
    wish.layout = QStringLiteral("both");
    wish.below = devicePixels(*plot_).height();
    wish.hasCurves = true;
    wish.curves = shownCurves();
  } else if (front == strips_ && document_->scene().sliding.kind != SlidingKind::Steady) {
    wish.layout = QStringLiteral("transient");
  }
  wish.scale = canvas_->devicePixelRatioF() * canvas_->textScale();
  wish.dark = dark_;
  wish.overlay = QString::fromUtf8(wordFor(canvas_->viewer().overlay()).data());
  const std::optional<ContactShot> present = shot();
  // A frame of the scene before has not yet been replaced: fitted ones will do.
  if (present && present->frame->sceneNumber == session_->sceneNumber()) {
    wish.frame = present->frame;
    wish.options = present->options;
  }
  return renderCommand(document_->origin(), document_->scene(), wish);
}

void MainWindow::copyText(const QString& text) {
  QGuiApplication::clipboard()->setText(text);
  status_->say(tr("On the clipboard: %1").arg(text.section(' ', 0, 2) + " …"));
}

}  // namespace asperity
