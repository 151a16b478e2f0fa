// The slim bar of the guided tour over the views: where one is, what is to be seen, what to try,
// and the way on. GUI thread; belongs to its parent.
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace asperity {

class TourBar : public QFrame {
  Q_OBJECT

 public:
  explicit TourBar(QWidget* parent = nullptr);

  /// From 0.
  void showStep(int step);
  int step() const { return step_; }

 signals:
  void stepWanted(int step);
  void ended();

 private:
  QPushButton* addButton(const char* name, const QString& text);

  int step_ = 0;
  QLabel* text_;
  QPushButton *back_, *next_, *end_;
};

}  // namespace asperity
