#include "ui/window/main/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QTextLayout>
#include <QToolButton>
#include <exception>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

/// Returns the text as far as it fits into so many lines of this width, with an ellipsis after a
/// word where that is not all.
QString inLines(const QString& text, int lines, int width, const QFont& font) {
  QTextLayout layout(text, font);
  layout.beginLayout();
  qsizetype lastBegin = 0;
  bool isWhole = true;
  for (int i = 0;; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(width);
    isWhole = i < lines;
    if (!isWhole) break;
    lastBegin = line.textStart();
  }
  layout.endLayout();
  if (isWhole) return text;
  const QString rest = text.mid(lastBegin);
  const QString fitting = QFontMetrics(font).elidedText(rest, Qt::ElideRight, width);
  return text.left(lastBegin) + shortened(rest, fitting.size());
}

/// Returns the label of a key of the scene, of a list with the number of its row.
QString subjectText(const QString& key) {
  const Parameter* parameter = findParameter(key.section('[', 0, 0).toStdString());
  if (!parameter) return key;
  const QString label = labelText(*parameter);
  const QString row = key.section('[', 1).section(']', 0, 0);
  return row.isEmpty() ? label : MessageBar::tr("%1, row %2").arg(label).arg(row.toInt() + 1);
}

QString sceneErrorText(const Message& english) {
  return withLabels(translatedText(english));
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      label_(textLabel("messageText")),
      more_(named<QToolButton>("moreOfMessage")),
      accept_(named<QPushButton>("acceptOffer")),
      close_(named<QToolButton>("closeMessage")) {
  setObjectName("messageBar");
  accept_->setAutoDefault(false);
  accept_->setFocusPolicy(Qt::TabFocus);
  accept_->hide();
  connect(accept_, &QPushButton::clicked, this, &MessageBar::accepted);
  more_->setFocusPolicy(Qt::TabFocus);
  more_->hide();
  connect(more_, &QToolButton::clicked, this, [this] {
    showsAll_ = !showsAll_;
    fitText();
  });
  close_->setText(QStringLiteral("✕"));
  close_->setFocusPolicy(Qt::TabFocus);
  connect(close_, &QToolButton::clicked, this, [this] {
    hide();
    markParameter();
    emit closed();
  });

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 7, 10, 7);
  layout->addWidget(label_, 1);
  layout->addWidget(more_, 0, Qt::AlignTop);
  layout->addWidget(accept_, 0, Qt::AlignTop);
  layout->addWidget(close_, 0, Qt::AlignTop);
  hide();
  keepTranslated(*this, [this] { showTexts(); });
}

void MessageBar::showTexts() {
  close_->setAccessibleName(tr("close message"));
  accept_->setAccessibleName(offerButton_.isEmpty() ? tr("accept") : offerButton_);
  accept_->setText(offerButton_);
  text_ = source_;
  fitText();
  if (sceneError_ && !isHidden() && failure_ == Failure::Scene)
    updateSceneError();
  else
    markParameter();
}

void MessageBar::showOffer(const LiveText& text, const LiveText& button) {
  failure_ = Failure::None;
  source_ = text;
  offerButton_ = button;
  showTexts();
  accept_->show();
  show();
}

void MessageBar::showSceneError(const QString& key, const Message& english) {
  // The contact and the curve complain about the same scene, one after the other: a message that
  // came between them stays.
  std::pair error(key, english);
  const bool isKnown = sceneError_ == error;
  sceneError_ = std::move(error);
  if (!isKnown || isHidden() || failure_ == Failure::Scene) updateSceneError();
}

void MessageBar::updateSceneError() {
  const auto error = *sceneError_;  // key and text
  showFailure(Failure::Scene, [error] {
    const QString subject = subjectText(error.first);
    const QString text = sceneErrorText(error.second);
    return subject.isEmpty() ? text : subject + ": " + text;
  });
}

void MessageBar::markParameter() {
  if (!sceneError_) return;
  const bool isShownHere = !isHidden() && failure_ == Failure::Scene;
  emit sceneErrorShown(sceneError_->first, isShownHere
                                               ? tr("not possible; the message above says why")
                                               : sceneErrorText(sceneError_->second));
}

void MessageBar::sceneRuns() {
  sceneError_.reset();
  end(Failure::Scene);
}

void MessageBar::forget() {
  sceneError_.reset();
  hide();
}

void MessageBar::showFailure(Failure source, const LiveText& text) {
  offerButton_ = {};
  accept_->hide();
  failure_ = source;
  setNote(false);
  showText(text);
  show();
  markParameter();
}

std::function<void(const LiveText& reason)> MessageBar::failureReporter(Failure source) {
  return [this, source](const LiveText& reason) { showFailure(source, reason); };
}

bool MessageBar::end(Failure source) {
  if (isHidden() || failure_ != source) return false;
  hide();
  if (sceneError_) updateSceneError();
  return true;
}

bool MessageBar::succeeds(Failure source, const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    showFailure(source, liveError(error));
    return false;
  }
  end(source);
  return true;
}

void MessageBar::showMessage(const LiveText& text) {
  showFailure(Failure::None, text);
}

void MessageBar::showNote(const LiveText& text) {
  showMessage(text);
  setNote(true);
}

/// Chooses the colours of an error or of a note, which the style sheet of the window has.
void MessageBar::setNote(bool isNote) {
  for (QWidget* part : Widgets{this, label_, more_, close_})
    setStyleProperty(*part, "note", isNote);
}

void MessageBar::showText(const LiveText& text) {
  source_ = text;
  const QString before = std::exchange(text_, source_);
  if (text_ != before) showsAll_ = false;
  fitText();
}

void MessageBar::setLineLimit(int lines) {
  if (std::exchange(lineLimit_, lines) == lines) return;
  fitText();
}

/// Shortens the text where it has more lines than the limit. The button for the rest takes its
/// width from the text only then.
void MessageBar::fitText() {
  const QString whole = keptTogether(text_);
  const QMargins margins = layout()->contentsMargins();
  const int gap = layout()->spacing();
  int available = width() - margins.left() - margins.right() - close_->sizeHint().width() - gap;
  if (!accept_->isHidden()) available -= accept_->sizeHint().width() + gap;
  label_->ensurePolished();
  const QFont font = label_->font();
  const bool isLong = lineLimit_ > 0 && inLines(whole, lineLimit_, available, font) != whole;
  more_->setText(showsAll_ ? tr("less") : tr("more"));
  available -= more_->sizeHint().width() + gap;
  const bool isCut = isLong && !showsAll_;
  label_->setText(isCut ? inLines(whole, lineLimit_, available, font) : whole);
  label_->setToolTip(isCut ? wrappedTip(text_) : QString());
  label_->setAccessibleName(isCut ? text_ : QString());
  // This comes last: the button may move the parts, which fits the text again to the new width.
  more_->setVisible(isLong);
}

void MessageBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) fitText();
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange && lineLimit_ > 0) fitText();
}

}  // namespace asperity
