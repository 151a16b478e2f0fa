// Saves the handout of a lesson: dialogs choose its readers and its file, and it is written in the
// background. GUI thread; owned by the window of the dialogs. Failure: statusChanged() gives one
// sentence.
#pragma once

#include <QObject>
#include <QString>

#include "core/lesson/lesson.h"
#include "ui/window/tasks/background_work.h"

class QWidget;

namespace asperity {

class HandoutSaver : public QObject {
  Q_OBJECT

 public:
  explicit HandoutSaver(QWidget* window);

  /// Asks, and saves unless that is cancelled. name: of the file, without its extension.
  void ask(const Lesson& lesson, const QString& name);
  /// Saves HTML or PDF, by the extension.
  void save(const Lesson& lesson, const QString& file, bool forTeacher);
  bool isSaving() const { return isSaving_; }

 signals:
  /// Emitted with the progress: the handout is being made, is saved, or cannot be saved.
  void statusChanged(const QString& text);
  void saved(const QString& file);
  /// Emitted when saving begins and ends.
  void savingChanged();

 private:
  void end(const QString& text);

  QWidget* window_;
  bool isSaving_ = false;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
