#include "ui/window/export/export_dialog.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/export/export_form.h"
#include "ui/window/export/export_preview.h"
#include "ui/window/export/export_size_fields.h"
#include "ui/window/main/file_dialogs.h"

namespace asperity {

namespace {

constexpr int kPreviewPause = 250;     // ms without a change before the preview is requested
constexpr double kPreview = 640;       // largest width or height of a preview, pixels
constexpr double kMin = 160;           // smallest side of a picture that a command draws
constexpr double kMinDensity = 24;     // smallest density of a picture, pixels per inch
constexpr double kMaxDensity = 1536;   // and the largest
constexpr std::int64_t kLines = 8;     // of the curve in a preview
constexpr int kFigureLines = 4;        // of a figure of the paper in a preview
constexpr qint64 kTableBytes = 16000;  // of a table that are shown

/// Returns the beginning of a table, up to the end of a line.
QString firstLines(QFile& table) {
  QByteArray text = table.read(kTableBytes);
  if (!table.atEnd()) text.truncate(text.lastIndexOf('\n') + 1);
  return QString::fromUtf8(text);
}

}  // namespace

ExportDialog::ExportDialog(Subject subject, ExportKind kind, const QString& program,
                           QWidget* parent)
    : QDialog(parent),
      subject_(std::move(subject)),
      form_(new ExportForm(subject_.scene.sliding.kind != SlidingKind::Steady, subject_.shown)),
      preview_(new ExportPreview),
      file_(named<QLineEdit>("exportFile")),
      command_(fixedText("exportCommand")),
      failure_(errorTextLabel("exportFailure")),
      progress_(named<QProgressBar>("exportProgress")),
      quiet_(new QTimer(this)),
      previews_(new CommandRun(program, this)),
      writing_(new CommandRun(program, this)) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export"));
  form_->setKind(kind);

  auto* scroll = scrolled(form_, Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);  // its controls take the focus
  scroll->setMinimumWidth(form_->minimumWidth() + 16);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(14);
  middle->addWidget(scroll, 2);
  middle->addWidget(preview_, 3);
  auto* column = new QVBoxLayout(this);
  column->addLayout(middle, 1);
  column->addWidget(makeBottom());
  write_->setDefault(true);  // which takes a dialog around it

  quiet_->setSingleShot(true);
  quiet_->setInterval(kPreviewPause);
  connect(quiet_, &QTimer::timeout, this, &ExportDialog::requestPreview);
  connect(form_, &ExportForm::changed, this, &ExportDialog::requestChanged);
  connect(file_, &QLineEdit::textEdited, this, &ExportDialog::fileChanged);
  connect(previews_, &CommandRun::done, this, &ExportDialog::takePreview);
  connect(previews_, &CommandRun::failed, this, &ExportDialog::previewFailed);
  connect(writing_, &CommandRun::progressed, this, [this](double part, const QString& of) {
    progress_->setFormat(of + QStringLiteral(": %p %"));
    showPart(*progress_, part);
  });
  connect(writing_, &CommandRun::done, this, [this] {
    showRunning(false);
    const QString written = file();
    if (!QFileInfo::exists(written)) return showFailure(noFileReason());
    emit exported(written);
    QDialog::accept();
  });
  connect(writing_, &CommandRun::failed, this,
          [this](const QString& reason, const NeededHeight& needed) {
            showRunning(false);
            showFailure(form_->inWords(reason, needed));
            hasWriteFailed_ = true;
          });
  extension_ = form_->extension();
  defaultName_ = defaultName();
  setFile(QDir(proposedFolder(subject_.origin.file)).filePath(defaultName_));
  resize(940, 620);
  requestChanged();
}

ExportDialog::~ExportDialog() = default;

/// Makes file, command, message and buttons.
QWidget* ExportDialog::makeBottom() {
  auto* bottom = new QWidget;
  auto* grid = new QGridLayout(bottom);
  grid->setContentsMargins(0, 4, 0, 0);
  auto* fileLabel = new QLabel(tr("File &name"));
  fileLabel->setBuddy(file_);
  file_->setAccessibleName(tr("file name"));
  browse_ = named<QPushButton>("exportBrowse", tr("&Browse…"));
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::askFile);
  grid->addWidget(fileLabel, 0, 0);
  grid->addWidget(file_, 0, 1);
  grid->addWidget(browse_, 0, 2);

  auto* commandLabel = new QLabel(tr("Command line"));
  commandLabel->setAlignment(Qt::AlignTop);
  command_->setAccessibleName(tr("command line that writes the same file"));
  command_->setTabChangesFocus(true);
  command_->setFixedHeight(4 * QFontMetrics(command_->font()).lineSpacing() + 14);
  auto* copy = named<QPushButton>("exportCopy", tr("&Copy"));
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(command_->toPlainText()); });
  grid->addWidget(commandLabel, 1, 0);
  grid->addWidget(command_, 1, 1);
  grid->addWidget(copy, 1, 2, Qt::AlignTop);

  failure_->setMinimumHeight(2 * QFontMetrics(failure_->font()).lineSpacing());
  progress_->setAccessibleName(tr("progress of the export"));
  progress_->setTextVisible(true);
  auto* row = new QHBoxLayout;
  row->addStrut(failure_->minimumHeight());  // so that nothing moves while the bar is shown
  row->addWidget(failure_, 1);
  row->addWidget(progress_, 1);
  close_ = named<QPushButton>("exportClose");
  connect(close_, &QPushButton::clicked, this, &ExportDialog::reject);
  write_ = named<QPushButton>("exportWrite", tr("&Export"));
  connect(write_, &QPushButton::clicked, this, &ExportDialog::write);
  row->addWidget(close_);
  row->addWidget(write_);
  grid->addLayout(row, 2, 0, 1, 3);
  showRunning(false);
  return bottom;
}

/// Returns the name that is proposed for what is exported.
QString ExportDialog::defaultName() const {
  if (form_->kind() == ExportKind::Figure) return QStringLiteral("paper_figures");
  const QString extension = form_->extension();
  return subject_.name + (extension.isEmpty() ? QStringLiteral("_frames") : extension);
}

QString ExportDialog::file() const {
  return file_->text().trimmed();
}

void ExportDialog::setFile(const QString& file) {
  file_->setText(file);
  fileChanged();
}

/// Another file may be writable where the last one was not. What is wrong with the preview stays.
void ExportDialog::fileChanged() {
  // A typed ending chooses the format.
  const QString ending = '.' + QFileInfo(file()).suffix().toLower();
  if (ending != form_->extension()) form_->chooseExtension(ending);
  showCommand();
  if (hasWriteFailed_) showFailure({});
}

QStringList ExportDialog::words() const {
  const QString name = file().isEmpty() ? defaultName() : file();
  return exportWords(
      subject_.origin, subject_.scene, form_->request(), subject_.shown,
      QFileInfo(QDir(proposedFolder(subject_.origin.file)), name).absoluteFilePath());
}

void ExportDialog::askFile() {
  QFileDialog dialog(this, tr("Export"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  if (form_->extension().isEmpty()) {
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
  } else {
    dialog.setDefaultSuffix(form_->extension().mid(1));
    dialog.setNameFilter(QStringLiteral("*") + form_->extension());
  }
  dialog.selectFile(file());
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  chosenFile_ = dialog.selectedFiles().front();
  setFile(chosenFile_);
}

/// Gives the file the extension of its format. A name that is still the usual one becomes that of
/// what is exported now.
void ExportDialog::renameFile() {
  static const QStringList known{".png", ".svg",  ".pdf", ".mp4", ".webm",
                                 ".gif", ".webp", ".csv", ".json"};
  const QString extension = form_->extension(), name = file();
  const QString lastDefault = std::exchange(defaultName_, defaultName());
  const bool isOther = std::exchange(extension_, extension) != extension;
  if (name.endsWith('/' + lastDefault))
    return file_->setText(name.chopped(lastDefault.size()) + defaultName_);
  const QString last = '.' + QFileInfo(name).suffix().toLower();
  if (known.contains(last)) {
    if (last != extension) file_->setText(name.chopped(last.size()) + extension);
  } else if (isOther && !name.isEmpty()) {
    file_->setText(name + extension);
  }
}

/// Shows the command at once; the preview waits until the user pauses.
void ExportDialog::requestChanged() {
  raised_.clear();
  renameFile();
  showCommand();
  previews_->cancel();
  showFailure({});
  preview_->showWork(tr("The preview is being made…"));
  quiet_->start();
}

void ExportDialog::showCommand() {
  command_->setPlainText(commandText(words()));
}

// ---- Preview

/// Returns the request for one figure as a mean over few lines.
ExportRequest ExportDialog::previewOfFigure(ExportRequest request, QStringList& notes) const {
  const bool hasSeveral = request.content == "paper" || request.content == "all";
  if (hasSeveral) request.content = QStringLiteral("2");
  if (hasSeveral) notes += tr("Figure 2 of them.");
  if (request.content != "1" && request.realizations.toInt() > kFigureLines) {
    notes += tr("The curve of the preview is the mean of %1 lines, that of the file of %2.")
                 .arg(kFigureLines)
                 .arg(request.realizations);
    request.realizations = QString::number(kFigureLines);
  }
  return request;
}

/// Gives a picture the size of the preview, with smaller texts and lines. A size or a resolution
/// that is not allowed is passed to the command, which reports the error.
void ExportDialog::shrink(ExportRequest& request) const {
  const QSizeF pixels = form_->size().pixels();
  if (pixels.isEmpty() || request.size.isEmpty()) return;
  const double large = std::max(pixels.width(), pixels.height());
  const double small = std::min(pixels.width(), pixels.height());
  const QString given = QString(request.scale).remove("dpi");
  const bool isOnPaper = request.size.contains("mm");
  const double density = given.isEmpty() ? (isOnPaper ? 300 : 96) : given.toDouble();
  if (!(density >= kMinDensity && density <= kMaxDensity)) return;
  const double factor =
      std::max({std::min(1.0, kPreview / large), kMin / small, kMinDensity / density});
  if (factor >= 1) return;
  request.scale = QString::number(density * factor, 'g', 8) + "dpi";
  if (!isOnPaper)
    request.size = QStringLiteral("%1x%2")
                       .arg(std::lround(pixels.width() * factor))
                       .arg(std::lround(pixels.height() * factor));
}

/// Runs the command for fewer pixels and fewer lines. A film is shown by one picture.
void ExportDialog::requestPreview() {
  if (const QString errorText = form_->errorText(); !errorText.isEmpty()) return refuse(errorText);
  ExportRequest request = form_->request();
  QString extension = form_->extension();
  QStringList notes;
  if (request.kind == ExportKind::Film) {
    request.kind = ExportKind::Picture;
    notes += tr("One picture of the film, which begins at time 0.");
  }
  if (request.kind == ExportKind::Figure) request = previewOfFigure(request, notes);
  if (request.kind == ExportKind::Picture) extension = ".png";
  shrink(request);
  const bool hasCurve = request.content == "curve" || request.content == "both";
  if (hasCurve && subject_.scene.ensemble.realizations > kLines) {
    request.further += {"--set", QStringLiteral("ensemble.realizations=%1").arg(kLines)};
    notes += tr("The curve of the preview is the mean of %1 lines, that of the file of %2.")
                 .arg(kLines)
                 .arg(subject_.scene.ensemble.realizations);
  }
  if (!raised_.isEmpty()) notes.prepend(raised_);
  previewNote_ = notes.join(' ');
  previewFile_ = folder_.filePath(QStringLiteral("preview_%1%2").arg(++number_).arg(extension));
  previewFigure_ = request.kind == ExportKind::Figure ? request.content : QString();
  if (!form_->isTyped("--threads")) request.further += {"--threads", "1"};
  previews_->run(
      exportWords(subject_.origin, subject_.scene, request, subject_.shown, previewFile_),
      folder_.path());
}

/// Makes the usual size as high as its diagrams need, with a note; other refusals are shown.
void ExportDialog::previewFailed(const QString& reason, const NeededHeight& needed) {
  ExportSizeFields& size = form_->size();
  const std::optional<double> height =
      form_->isTyped("--size") ? std::nullopt : size.heightEnough(needed);
  if (!height || !size.raiseHeight(*height)) return refuse(form_->inWords(reason, needed));
  raised_ = tr("The picture is %1 pixels high, because its diagrams need that.").arg(*height);
  showCommand();
  requestPreview();
}

/// Shows why there is no preview, and so nothing to export.
void ExportDialog::refuse(const QString& reason) {
  showFailure(reason);
  preview_->showPicture({}, tr("No preview."));
}

void ExportDialog::takePreview() {
  if (!QFileInfo::exists(previewFile_)) return refuse(noFileReason());
  showFailure({});
  QFile made(previewFile_);
  if (!previewFigure_.isEmpty()) {
    QDir figures(previewFile_);
    preview_->showPicture(
        QImage(figures.filePath(QStringLiteral("figure_%1.png").arg(previewFigure_))),
        previewNote_);
    figures.removeRecursively();
  } else if (form_->kind() == ExportKind::Table) {
    if (made.open(QIODevice::ReadOnly)) preview_->showTable(firstLines(made), previewNote_);
  } else {
    preview_->showPicture(QImage(previewFile_), previewNote_);
  }
  made.remove();
}

// ---- Writing

/// Asks where files would be replaced.
bool ExportDialog::confirmReplace(const QFileInfo& target) {
  QString question;
  if (target.isDir() && !QDir(target.absoluteFilePath()).isEmpty())
    question = tr("The folder %1 has files already. Replace those of the same names?");
  else if (target.exists() && !target.isDir() && target.absoluteFilePath() != chosenFile_)
    question = tr("%1 exists already. Replace it?");
  return question.isEmpty() || askReplace(this, windowTitle(), question.arg(target.fileName()));
}

void ExportDialog::write() {
  const QFileInfo target(words().at(words().indexOf("-o") + 1));
  if (!confirmReplace(target)) return;
  rememberFolder(target.absoluteFilePath());
  file_->setText(target.absoluteFilePath());
  showCommand();
  if (quiet_->isActive() || previews_->isRunning()) preview_->showWork({});
  previews_->cancel();
  quiet_->stop();
  showFailure({});
  showRunning(true);
  writing_->run(words(), folder_.path());
}

void ExportDialog::showFailure(const QString& reason) {
  hasWriteFailed_ = false;
  failure_->setText(reason);
  write_->setEnabled(reason.isEmpty() && !writing_->isRunning());
}

/// While the file is written nothing can be changed, and the button that closes cancels.
void ExportDialog::showRunning(bool isRunning) {
  for (QWidget* control : Widgets{form_, file_, browse_, write_}) control->setEnabled(!isRunning);
  progress_->setVisible(isRunning);
  failure_->setVisible(!isRunning);
  progress_->setRange(0, 0);
  close_->setText(isRunning ? tr("Cance&l") : tr("Close"));
}

/// Escape first cancels the export.
void ExportDialog::reject() {
  if (!writing_->isRunning()) return QDialog::reject();
  writing_->cancel();
  showRunning(false);
  showFailure({});
  requestChanged();
}

}  // namespace asperity
