// The dock of a lesson above that of the parameters: the title of the lesson, the buttons that save
// its results and end it, and the pane of its steps. It shares the height with the parameters. The
// buttons that lead from step to step stand in a dock of their own at the bottom edge, where they
// do not move when the height is shared anew. GUI thread; owned by the window. Cannot fail.
#pragma once

#include <QDockWidget>

class QLabel;
class QMainWindow;
class QScrollArea;
class QToolButton;

namespace asperity {

class LessonPane;
class ParameterPanel;

class LessonDock : public QDockWidget {
  Q_OBJECT

 public:
  /// parameters: the dock of the panel.
  LessonDock(QMainWindow& window, QDockWidget& parameters, const ParameterPanel& panel);

  LessonPane& pane() { return *pane_; }
  void showTitle(const QString& title);

  /// Shows the dock, and the one of the parameters, with their heights at the start of a lesson,
  /// and the buttons below both.
  void begin();
  /// Shares the height when the rows and the texts of a step have theirs, after the next events.
  void shareHeightSoon();
  /// Shows or hides the buttons with it.
  void setVisible(bool isVisible) override;

 signals:
  void savingRequested();
  void endRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTitleBar();
  void shareHeight(int corrections = 1);
  void followRows();

  QMainWindow& window_;
  QDockWidget& parameters_;
  const ParameterPanel& panel_;
  LessonPane* pane_;
  QDockWidget* foot_;  // of the pane
  QLabel* title_;
  QToolButton *keep_, *close_;
  QScrollArea* rows_;   // of the parameters, which belong to the panel
  int rowsHeight_ = 0;  // pixels that the rows need
  bool isBeginning_ = false;
};

}  // namespace asperity
