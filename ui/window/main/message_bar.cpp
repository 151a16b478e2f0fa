#include "ui/window/main/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      label_(textLabel("messageText")),
      accept_(named<QPushButton>("acceptOffer")),
      close_(named<QToolButton>("closeMessage")) {
  setObjectName("messageBar");
  accept_->setAutoDefault(false);
  accept_->setFocusPolicy(Qt::TabFocus);
  accept_->hide();
  connect(accept_, &QPushButton::clicked, this, &MessageBar::accepted);
  close_->setText(QStringLiteral("✕"));
  close_->setFocusPolicy(Qt::TabFocus);
  connect(close_, &QToolButton::clicked, this, [this] {
    hide();
    emit closed();
  });

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 7, 10, 7);
  layout->addWidget(label_, 1);
  layout->addWidget(accept_, 0, Qt::AlignTop);
  layout->addWidget(close_, 0, Qt::AlignTop);
  hide();
  keepTranslated(*this, [this] { showTexts(); });
}

void MessageBar::showTexts() {
  close_->setAccessibleName(tr("close message"));
  accept_->setAccessibleName(offerButton_ ? offerButton_() : tr("accept"));
  if (offer_) {
    showText(offer_());
    accept_->setText(offerButton_());
  }
  if (sceneError_ && !isHidden() && failure_ == Failure::Scene) updateSceneError();
}

void MessageBar::showOffer(Text text, Text button) {
  failure_ = Failure::None;
  offer_ = std::move(text);
  offerButton_ = std::move(button);
  showTexts();
  accept_->show();
  show();
}

void MessageBar::showSceneError(const QString& key, const Message& english) {
  sceneError_ = {key, english};
  updateSceneError();
}

void MessageBar::updateSceneError() {
  const auto& [key, english] = *sceneError_;
  const QString text = withLabels(translatedText(english));
  const Parameter* parameter = findParameter(key.section('[', 0, 0).toStdString());
  QString subject = parameter ? ParameterRow::labelText(*parameter) : key;
  if (const QString row = key.section('[', 1).section(']', 0, 0); parameter && !row.isEmpty())
    subject = tr("%1, row %2").arg(subject).arg(row.toInt() + 1);
  showFailure(Failure::Scene, subject.isEmpty() ? text : subject + ": " + text);
  emit sceneErrorShown(key, text);
}

void MessageBar::sceneRuns() {
  sceneError_.reset();
  end(Failure::Scene);
}

void MessageBar::forget() {
  sceneError_.reset();
  hide();
}

void MessageBar::showFailure(Failure source, const QString& text) {
  showMessage(text);
  failure_ = source;
}

bool MessageBar::end(Failure source) {
  if (isHidden() || failure_ != source) return false;
  hide();
  if (sceneError_) updateSceneError();
  return true;
}

void MessageBar::showMessage(const QString& text) {
  offer_ = offerButton_ = nullptr;
  accept_->hide();
  failure_ = Failure::None;
  showText(text);
  show();
}

void MessageBar::showText(const QString& text) {
  text_ = text;
  label_->setText(keptTogether(text));
}

}  // namespace asperity
