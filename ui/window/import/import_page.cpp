#include "ui/window/import/import_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/base/text_encoding.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

constexpr std::size_t kShownBytes = 4096;

/// Returns the first whole lines of a text file; empty where the file is no text.
QString readBeginning(const std::string& name) {
  try {
    const RegularFile file(name);
    std::string bytes = file.read(0, kShownBytes);
    if (file.size() > bytes.size())
      bytes.resize(bytes.find_last_of('\n') + 1);  // 0 without the end of a line
    const DecodedText decoded(bytes, name);
    return QString::fromUtf8(decoded.text.data(), static_cast<qsizetype>(decoded.text.size()));
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

ImportPage::ImportPage(const QString& file, const QString& accept, QWidget* parent)
    : QDialog(parent),
      file_(file),
      shown_(new QWidget),
      views_(marginless<QVBoxLayout>(shown_, 8)),
      beginning_(fixedText("importBeginning")),
      halves_(new QHBoxLayout),
      message_(errorTextLabel("importComplaint")),
      progressText_(new QLabel(tr("reading…"))),
      progress_(thinProgress("importProgress")),
      stop_(named<QToolButton>("importStop")),
      accept_(named<QPushButton>("importAccept", accept)),
      cancel_(pageButton("importCancel", tr("&Cancel"), this, &QDialog::reject)) {
  auto* name = named<QLabel>("importFile", QFileInfo(file).fileName());
  name->setToolTip(QDir::toNativeSeparators(file));
  name->setTextFormat(Qt::PlainText);
  name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  name->setFont(boldFont(name->font()));
  beginning_->setAccessibleName(tr("the first lines of the file"));
  beginning_->setLineWrapMode(QPlainTextEdit::NoWrap);
  beginning_->setPlaceholderText(tr("Nothing of this file can be shown."));
  beginning_->hide();
  auto* left = new QVBoxLayout;
  left->setSpacing(8);
  left->addWidget(name);
  left->addWidget(shown_, 1);
  left->addWidget(beginning_, 1);
  left->addStretch(0);  // below the name, before the file is read
  halves_->setSpacing(12);
  halves_->addLayout(left, 1);

  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves_, 1);
  resizePage(*this, {1120, 720});
  connect(this, &QDialog::finished, this, &ImportPage::deleteWhenFinished);
}

/// Adds the error and the buttons below the widgets of the derived class, and so after them in the
/// order of the Tab key.
void ImportPage::addFoot(QVBoxLayout& page) {
  message_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  progress_->setAccessibleName(tr("progress of reading"));
  stop_->setAutoRaise(true);
  connect(stop_, &QToolButton::clicked, this, &ImportPage::pressStop);
  accept_->setDefault(true);
  connect(accept_, &QPushButton::clicked, this, &QDialog::accept);
  auto* foot = new QHBoxLayout;
  foot->addWidget(message_, 1);
  foot->addWidget(progressText_);
  foot->addWidget(progress_);
  foot->addWidget(stop_);
  foot->addSpacing(8);
  foot->addWidget(cancel_);
  foot->addWidget(accept_);
  page.addLayout(foot);
}

QScrollArea* ImportPage::scrolledTexts(Widgets texts, int lines, const QString& name) const {
  auto* content = new QWidget;
  auto* column = marginless<QVBoxLayout>(content, 4);
  for (QWidget* text : texts) column->addWidget(text);
  column->addStretch(1);
  QScrollArea* area = scrolled(content, Qt::ScrollBarAlwaysOff);
  area->setFixedHeight(lines * fontMetrics().lineSpacing());
  area->setAccessibleName(name);
  return area;
}

QString ImportPage::sentence(QString text) {
  if (text.isEmpty()) return text;
  text = capitalized(text);
  return text.endsWith('.') ? text : text + '.';
}

QString ImportPage::errorText() const {
  return message_->text();
}

void ImportPage::restart() {
  if (!accept_->parentWidget()) addFoot(*static_cast<QVBoxLayout*>(layout()));
  setState(State::Reading);
  begin();
}

void ImportPage::showProgress(double part) {
  showPart(*progress_, part);
}

void ImportPage::finish(const QString& errorText) {
  showFailure(errorText);
  setState(errorText.isEmpty() ? State::Shown : State::Wrong);
}

void ImportPage::showFailure(const QString& reason) {
  setMessage(*message_, reason, MessageKind::Error);
}

void ImportPage::setState(State state) {
  state_ = state;
  const bool isReading = state == State::Reading, isStopped = state == State::Stopped;
  if (isReading) showPart(*progress_, 0);
  for (QWidget* part : Widgets{progressText_, progress_}) part->setVisible(isReading);
  stop_->setVisible(isReading || isStopped);
  stop_->setText(isStopped ? QStringLiteral("↻") : QStringLiteral("✕"));
  const QString tip = isStopped ? tr("Read the file again") : tr("Stop reading");
  stop_->setToolTip(tip);
  stop_->setAccessibleName(tip);
  accept_->setEnabled(state == State::Shown);
  // The old widgets are hidden first: together with the new ones they are higher than the page,
  // which would grow.
  if (state == State::Shown) {
    beginning_->hide();
    shown_->show();
  } else if (state == State::Wrong) {
    shown_->hide();
    showBeginning();
  }
}

/// Shows the first lines of the file, so that the user can name its columns.
void ImportPage::showBeginning() {
  beginning_->setPlainText(readBeginning(file_.toStdString()));
  beginning_->show();
}

void ImportPage::pressStop() {
  if (state_ == State::Stopped) return restart();
  work().cancel();
  setMessage(*message_, tr("Reading was stopped"), MessageKind::Note);
  setState(State::Stopped);
}

/// Deletes the page after the worker has finished its earlier requests, so that the destructor does
/// not wait: a transform of a large surface, for example, cannot be stopped in its middle.
void ImportPage::deleteWhenFinished() {
  work().cancel();
  work().request([](const BackgroundWork::Run&) {}, [this] { deleteLater(); });
}

void ImportPage::keyPressEvent(QKeyEvent* event) {
  if (!pressByReturn(*this, *event)) QDialog::keyPressEvent(event);
}

}  // namespace asperity
