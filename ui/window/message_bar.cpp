#include "ui/window/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace asperity {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), label_(new QLabel) {
  setObjectName("messageBar");
  label_->setObjectName("messageText");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("close message"));
  close->setFocusPolicy(Qt::NoFocus);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 7, 10, 7);
  layout->addWidget(label_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::showMessage(const QString& text) {
  label_->setText(text);
  show();
}

QString MessageBar::text() const {
  return label_->text();
}

}  // namespace asperity
