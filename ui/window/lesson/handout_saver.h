// Saves the handout of a lesson from a window: asks for whom it is and where it goes, and writes it
// in the background. GUI thread; belongs to the window that asks. Failure: one sentence is told.
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
  /// HTML or PDF, by the extension.
  void save(const Lesson& lesson, const QString& file, bool forTeacher);
  bool isSaving() const { return isSaving_; }

 signals:
  /// What there is to say: that it is being made, that it is saved, or why it is not.
  void told(const QString& text);
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
