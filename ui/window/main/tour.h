// The guided tour: six shipped scenes in order, each with one sentence and one thing to try; the
// slim bar over the views that leads through it, and the hint at it. GUI thread; owned by the main
// window. Cannot fail: where a scene is missing the tour ends.
#pragma once

#include <QFrame>
#include <QObject>
#include <QString>
#include <span>

class QLabel;
class QMenu;
class QPushButton;

namespace asperity {

class Commands;
class DocumentCommands;
class MessageBar;
class SceneDocument;

struct TourStep {
  const char* scene;     // name of a shipped one
  const char* title;     // what happens
  const char* sentence;  // what is to be seen
  const char* attempt;   // what to try
};

std::span<const TourStep> tourSteps();

/// One of a step's texts in the language of the window.
QString tourText(const char* text);

/// Says where one is, what is to be seen and what to try, and has the buttons to go on.
class TourBar : public QFrame {
  Q_OBJECT

 public:
  explicit TourBar(QWidget* parent = nullptr);

  /// Counts from 0.
  void showStep(int step);
  int step() const { return step_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 signals:
  void stepWanted(int step);
  void ended();

 private:
  void showTexts();
  /// Room for the longest step, so that the buttons stay where they are.
  void keepHeight();
  QPushButton* addButton(const char* name);

  int step_ = 0;
  QLabel* text_;
  QPushButton *back_, *next_, *end_;
};

class Tour : public QObject {
  Q_OBJECT

 public:
  /// `hint`: the bar for the offer.
  Tour(SceneDocument& document, DocumentCommands& documents, TourBar& bar, MessageBar& hint,
       QObject* parent);

  void addTo(Commands& commands);

  void start();
  /// A small hint at the tour, until it was taken or put away once.
  void offer();
  bool isRunning() const { return isRunning_; }

 signals:
  /// The first step is about to be shown.
  void starting();
  /// The bar says what the description of the scene would.
  void stepShown();

 private:
  void show(int step);
  void end();

  SceneDocument& document_;
  DocumentCommands& documents_;
  TourBar& bar_;
  MessageBar& hint_;
  Commands* commands_ = nullptr;
  bool isRunning_ = false;
};

}  // namespace asperity
