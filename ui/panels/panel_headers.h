// What chooses the visible rows of the panel: the bar above them, with the essential ones or all
// and a filter, and the titles of the sections, which fold. GUI thread.
#pragma once

#include <QAbstractButton>
#include <QLineEdit>
#include <QStringList>
#include <QWidget>

class QToolButton;

namespace asperity {

/// A line to type a filter in. Escape clears it and leaves it.
class FilterLine : public QLineEdit {
  Q_OBJECT

 public:
  explicit FilterLine(QWidget* parent = nullptr);
  QSize minimumSizeHint() const override;

 signals:
  /// Emitted when Enter or the arrow down leaves the line for the first row that is found.
  void left();
  /// Emitted when Escape leaves the line, so that the keys are those of the window again.
  void escaped();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

/// The bar above the parameters.
class PanelBar : public QWidget {
  Q_OBJECT

 public:
  explicit PanelBar(QWidget* parent = nullptr);

  bool showsAll() const;
  void setShowsAll(bool all);

  /// Returns the words of the filter; none: all rows pass.
  QStringList words() const;
  FilterLine& filter() { return *filter_; }

  void showTexts();

 signals:
  void changed();

 private:
  QToolButton *essentials_, *all_;
  FilterLine* filter_;
};

/// The title of a section, which opens and folds its rows: by mouse, space bar or the arrows left
/// and right. While the section is folded it shows how many of its values are changed.
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
