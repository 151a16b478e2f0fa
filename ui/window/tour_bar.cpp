#include "ui/window/tour_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/window/tour.h"

namespace asperity {

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
  const auto count = static_cast<int>(tourSteps().size());
  const TourStep& present = tourSteps()[static_cast<std::size_t>(step)];
  text_->setText(tr("%1 of %2&ensp;<b>%3.</b> %4 <i>Try: %5</i>")
                     .arg(step + 1)
                     .arg(count)
                     .arg(tourText(present.title).toHtmlEscaped(),
                          tourText(present.sentence).toHtmlEscaped(),
                          tourText(present.attempt).toHtmlEscaped()));
  back_->setEnabled(step > 0);
  next_->setEnabled(step + 1 < count);
  show();
}

}  // namespace asperity
