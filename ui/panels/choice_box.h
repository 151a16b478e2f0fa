// A combo box in the panel's look; the wheel counts only while it has the focus. GUI thread.
#pragma once

#include <QComboBox>

namespace asperity {

class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace asperity
