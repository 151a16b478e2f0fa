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

  /// `changed`: values of the section that are not the default. `isUnfolded`: its rows are seen,
  /// as also those of a folded section are while the panel is filtered.
  void showState(const QString& title, int changed, bool isUnfolded);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QString remark_;
  bool isUnfolded_ = true;
};

}  // namespace asperity
