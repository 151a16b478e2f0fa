// The bar above the parameters: which of them are shown (the essential ones or all), and a line
// that filters them. GUI thread.
#pragma once

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

}  // namespace asperity
