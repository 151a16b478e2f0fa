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

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 signals:
  void stepWanted(int step);
  void ended();

 private:
  /// Room for the longest step, so that the buttons stay where they are.
  void keepHeight();
  QPushButton* addButton(const char* name, const QString& text);

  int step_ = 0;
  QLabel* text_;
  QPushButton *back_, *next_, *end_;
};

}  // namespace asperity
