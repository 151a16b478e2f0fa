#include "ui/window/main/tour_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/window/main/tour.h"

namespace asperity {

namespace {

int stepCount() {
  return static_cast<int>(tourSteps().size());
}

QString textOf(int index) {
  const TourStep& step = tourSteps()[static_cast<std::size_t>(index)];
  return TourBar::tr("%1 of %2&ensp;<b>%3.</b> %4 <i>Try: %5</i>")
      .arg(index + 1)
      .arg(stepCount())
      .arg(tourText(step.title).toHtmlEscaped(), tourText(step.sentence).toHtmlEscaped(),
           tourText(step.attempt).toHtmlEscaped());
}

}  // namespace

TourBar::TourBar(QWidget* parent) : QFrame(parent), text_(new QLabel) {
  setObjectName("tourBar");
  text_->setObjectName("tourText");
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 6, 10, 6);
  layout->setSpacing(8);
  layout->addWidget(text_, 1);
  back_ = addButton("tourBack", tr("Back"));
  next_ = addButton("tourNext", tr("Next"));
  end_ = addButton("tourEnd", tr("End"));
  connect(back_, &QPushButton::clicked, this, [this] { emit stepWanted(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { emit stepWanted(step_ + 1); });
  connect(end_, &QPushButton::clicked, this, &TourBar::ended);
  hide();
}

QPushButton* TourBar::addButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAutoDefault(false);
  button->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(button);
  return button;
}

void TourBar::showStep(int step) {
  step_ = step;
  text_->setText(textOf(step));
  back_->setEnabled(step > 0);
  next_->setEnabled(step + 1 < stepCount());
  show();
}

void TourBar::keepHeight() {
  QLabel measured(this);
  measured.setFont(text_->font());
  measured.setWordWrap(true);
  measured.setTextFormat(Qt::RichText);
  int height = 0;
  for (int step = 0; step < stepCount(); ++step) {
    measured.setText(textOf(step));
    height = std::max(height, measured.heightForWidth(text_->width()));
  }
  text_->setMinimumHeight(height);
}

void TourBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  keepHeight();
}

void TourBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) keepHeight();
}

}  // namespace asperity
