#include "ui/window/main/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace asperity {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), label_(new QLabel), accept_(new QPushButton) {
  setObjectName("messageBar");
  label_->setObjectName("messageText");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  accept_->setObjectName("acceptOffer");
  accept_->setAccessibleName(tr("accept"));
  accept_->setAutoDefault(false);
  accept_->setFocusPolicy(Qt::TabFocus);
  accept_->hide();
  connect(accept_, &QPushButton::clicked, this, &MessageBar::accepted);
  auto* close = new QToolButton;
  close->setObjectName("closeMessage");
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("close message"));
  close->setFocusPolicy(Qt::TabFocus);
  connect(close, &QToolButton::clicked, this, [this] {
    hide();
    emit closed();
  });

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 7, 10, 7);
  layout->addWidget(label_, 1);
  layout->addWidget(accept_, 0, Qt::AlignTop);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::showOffer(const QString& text, const QString& button) {
  accept_->setText(button);
  accept_->setAccessibleName(button);
  accept_->show();
  failure_ = Failure::None;
  label_->setText(text);
  show();
}

void MessageBar::showFailure(Failure of, const QString& text) {
  showMessage(text);
  failure_ = of;
}

bool MessageBar::end(Failure of) {
  if (isHidden() || failure_ != of) return false;
  hide();
  return true;
}

void MessageBar::showMessage(const QString& text) {
  accept_->hide();
  failure_ = Failure::None;
  label_->setText(text);
  show();
}

QString MessageBar::text() const {
  return label_->text();
}

}  // namespace asperity
