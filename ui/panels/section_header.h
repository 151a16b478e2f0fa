// The title of a section of the panel, which opens and folds its rows: by mouse, space bar or the
// arrows left and right. It says how many values are changed while they are not seen. GUI thread.
#pragma once

#include <QAbstractButton>

namespace asperity {

class SectionHeader : public QAbstractButton {
  Q_OBJECT

 public:
  explicit SectionHeader(QWidget* parent = nullptr);

  bool isOpen() const { return isChecked(); }
  void setOpen(bool open) { setChecked(open); }

  /// `changed`: values of the section that are not the default.
  void showState(const QString& title, int changed);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QString remark_;
};

}  // namespace asperity
