#include "ui/window/contact/contact_words.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>
#include <QStringList>
#include <QVBoxLayout>

#include "core/run/contact_report.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

/// Returns the sentences on the present frame. They leave out a curve that a student is to guess.
QStringList stateSentences(const Session& session) {
  if (!session.frame()) return {};
  const Frame& frame = *session.frame();
  CurveAtVelocity curve;
  if (!session.friction().isConcealed()) curve = readCurve(frame, session.curve());
  curve.notes.add(Note::SlopeAbove, frame.rmsSlope > kSmallSlope);
  QStringList sentences;
  for (const Message& sentence : describeContact(frame, curve))
    sentences += translatedText(sentence);
  return sentences;
}

}  // namespace

void ContactWords::showFor(const Session& session, ContactCanvas& canvas, QWidget& window) {
  if (!session.frame()) return;
  auto* words = window.findChild<ContactWords*>("contactWords", Qt::FindDirectChildrenOnly);
  if (!words) words = new ContactWords(session, canvas, &window);
  words->refresh();
  words->show();
  words->raise();
  words->activateWindow();
}

ContactWords::ContactWords(const Session& session, ContactCanvas& canvas, QWidget* parent)
    : QDialog(parent),
      session_(session),
      canvas_(canvas),
      text_(named<QPlainTextEdit>("contactWordsText")) {
  setObjectName("contactWords");
  setWindowTitle(tr("The contact in words"));
  setAttribute(Qt::WA_DeleteOnClose);
  text_->setAccessibleName(tr("state of the contact"));
  text_->setReadOnly(true);
  text_->setTabChangesFocus(true);
  // The text has a caret, with which the sentences are read line by line and selected.
  text_->setTextInteractionFlags(Qt::TextSelectableByKeyboard | Qt::TextSelectableByMouse);
  auto* renew = pageButton("contactWordsAgain", tr("&Renew"), this, &ContactWords::refresh);
  renew->setToolTip(
      tr("The state at this moment (%1)")
          .arg(QKeySequence(Qt::CTRL | Qt::Key_D).toString(QKeySequence::NativeText)));
  auto* copy = pageButton("contactWordsCopy", tr("&Copy"), this,
                          [this] { QGuiApplication::clipboard()->setText(text()); });
  auto* close = pageButton("contactWordsClose", tr("C&lose"), this, &QDialog::close);
  connect(new QShortcut(Qt::CTRL | Qt::Key_D, this), &QShortcut::activated, this,
          &ContactWords::refresh);
  auto* column = new QVBoxLayout(this);
  column->addWidget(text_, 1);
  column->addLayout(buttonRow({}, {renew, copy, close}));
  resize(600, 260);
  text_->setFocus();
}

QString ContactWords::text() const {
  return text_->toPlainText();
}

void ContactWords::refresh() {
  const QStringList sentences = stateSentences(session_);
  text_->setPlainText(sentences.join('\n'));
  setAccessibleDescription(sentences.join(' '));
  canvas_.setAccessibleDescription(sentences.join(' '));
  text_->setFocus();
}

}  // namespace asperity
