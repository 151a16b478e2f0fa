// The page of all lessons: what each teaches and how long it takes; it begins one, opens a file,
// and writes handouts. GUI thread. Failure: one line on the page says what is wrong.
#pragma once

#include <QDialog>
#include <QString>

#include "ui/window/tasks/background_work.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace asperity {

class LessonList : public QDialog {
  Q_OBJECT

 public:
  explicit LessonList(QWidget* parent);

  /// Writes the chosen lesson's handout (HTML or PDF, by the extension) in the background.
  void saveHandout(const QString& file, bool forTeacher);
  bool isSaving() const { return isSaving_; }
  /// The name of the chosen shipped lesson.
  QString chosen() const;

 signals:
  /// Emitted with the name of a shipped lesson, or a file.
  void lessonWanted(const QString& nameOrFile);
  void editorWanted(const QString& nameOrFile);
  void handoutSaved(const QString& file);

 private:
  void showTexts();
  void showChosen();
  void askFile();
  void askHandout();
  void begin();

  QListWidget* list_;
  QCheckBox* notes_;
  QLabel *about_, *status_;
  QPushButton *start_, *open_, *handout_, *edit_, *close_;
  bool isSaving_ = false;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
