// The common base of the pages that import a file of the user: the name of the file, progress that
// can be stopped, one line for an error, with the first lines of the file instead of the views, and
// the buttons that accept or discard the result. The work runs in the background; the newest
// choices win. A page that is closed disappears at once and deletes itself when its work has
// stopped, so that the window never waits for it. GUI thread.
#pragma once

#include <QDialog>
#include <QString>

#include "ui/panels/controls.h"
#include "ui/window/tasks/background_work.h"

class QHBoxLayout;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace asperity {

class ImportPage : public QDialog {
  Q_OBJECT

 public:
  /// Returns whether the result of the present choices is shown, or what is wrong with them.
  bool isReady() const { return state_ == State::Shown; }
  bool isReading() const { return state_ == State::Reading; }
  /// Returns the error message; empty without an error.
  QString errorText() const;

 protected:
  /// Returns a text of core as a sentence, with a capital letter and a full stop.
  static QString sentence(QString text);

  ImportPage(const QString& file, const QString& accept, QWidget* parent);

  QVBoxLayout& views() { return *views_; }    // left
  QHBoxLayout& halves() { return *halves_; }  // for the widgets at the right
  const QString& file() const { return file_; }
  /// Makes an area of so many lines, in which texts below each other scroll: what is beside it
  /// stays where it is. name: for screen readers.
  QScrollArea* scrolledTexts(Widgets texts, int lines, const QString& name) const;

  /// Begins again with the present choices; begin() of the derived class follows. Its constructor
  /// ends with the first call.
  void restart();
  virtual void begin() = 0;
  void showProgress(double part);
  /// Ends the reading, with what is wrong; empty: it can be accepted.
  void finish(const QString& errorText);
  /// Shows why the result could not be kept, such as a folder that is read-only. It stays, and can
  /// be accepted again.
  void showFailure(const QString& reason);
  /// Returns the background work of begin(). Its thread may run until this base is destroyed, so
  /// what it runs must not use members of the derived class.
  BackgroundWork& work() { return work_; }

  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class State { Reading, Shown, Wrong, Stopped };
  void addFoot(QVBoxLayout& page);
  void setState(State state);
  void pressStop();
  void showBeginning();
  void deleteWhenFinished();

  QString file_;
  State state_ = State::Reading;
  QWidget* shown_;  // holds the views
  QVBoxLayout* views_;
  QPlainTextEdit* beginning_;  // of the file, while something is wrong with it
  QHBoxLayout* halves_;
  QLabel *message_, *progressText_;
  QProgressBar* progress_;
  QToolButton* stop_;
  QPushButton *accept_, *cancel_;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
