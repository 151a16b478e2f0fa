// The guided tour: six shipped scenes in order, each with one sentence and one thing to try, and a
// frame around the control to try it with; the bar over the views with its texts and buttons; and
// the offer of the tour. Its end restores the previous scene. GUI thread; owned by the main window.
// Cannot fail: where a scene is missing the tour ends.
#pragma once

#include <QFrame>
#include <QObject>
#include <QString>
#include <span>

class QLabel;
class QPushButton;

namespace asperity {

class Commands;
class HighlightFrame;
class MessageBar;
class SceneDocument;

struct TourStep {
  const char* scene;     // name of a shipped scene
  const char* title;     // what happens
  const char* sentence;  // what can be seen
  const char* attempt;   // what to try
  const char* key;       // the parameter to try it with
};

/// Shows the number of the step, what can be seen and what to try, with the buttons to go on.
class TourBar : public QFrame {
  Q_OBJECT

 public:
  explicit TourBar(QWidget* parent = nullptr);

  /// Shows a step, counted from 0.
  void showStep(int step);
  int step() const { return step_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 signals:
  void stepRequested(int step);
  void ended();

 private:
  void showTexts();
  /// Keeps enough height for the longest step, so that the buttons do not move.
  void keepHeight();
  QPushButton* addButton(const char* name);

  int step_ = 0;
  QLabel* text_;
  QPushButton *back_, *next_, *end_;
};

class Tour : public QObject {
  Q_OBJECT

 public:
  /// Returns the steps in English; tr() translates their texts.
  static std::span<const TourStep> steps();

  /// `hint`: the bar that shows the offer. `window`: contains the controls.
  Tour(SceneDocument& document, TourBar& bar, MessageBar& hint, QWidget& window);

  void addTo(Commands& commands);

  void start();
  /// Offers the tour in the bar, until the user has accepted or closed the offer once.
  void offer();
  bool isRunning() const { return isRunning_; }

 signals:
  /// Emitted before the first step is shown.
  void starting();
  /// Emitted when a step is shown; the bar then replaces the description of the scene.
  void stepShown();
  /// Emitted before the frame goes around the control of this key, which has to be visible then.
  void controlRequested(const QString& key);

 private:
  void show(int step);
  void end();
  void close();
  void highlight(const char* key);

  SceneDocument& document_;
  QWidget& window_;
  HighlightFrame* highlight_;
  TourBar& bar_;
  MessageBar& hint_;
  Commands* commands_ = nullptr;
  bool isRunning_ = false;
};

}  // namespace asperity
