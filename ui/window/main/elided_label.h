// A line of text that is shortened where it has no room, and then whole in its tooltip. GUI thread;
// owned by its parent. Cannot fail.
#pragma once

#include <QLabel>

namespace asperity {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// What is to be seen of the text.
  QString shownText() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace asperity
