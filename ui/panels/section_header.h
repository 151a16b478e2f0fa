// The title of a section of the panel, which opens and folds its rows: by mouse, space bar or the
// arrows left and right. While the section is folded it shows how many of its values are changed.
// GUI thread.
#pragma once

#include <QAbstractButton>

namespace asperity {

class SectionHeader : public QAbstractButton {
  Q_OBJECT

 public:
  explicit SectionHeader(QWidget* parent = nullptr);

  bool isOpen() const { return isChecked(); }
  void setOpen(bool open) { setChecked(open); }

  /// Shows the title and its state. `changed`: number of values of the section that are not the
  /// default. `isUnfolded`: its rows are visible; rows of a folded section can also be visible
  /// while the panel is filtered.
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
