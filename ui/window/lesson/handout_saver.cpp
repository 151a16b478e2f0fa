#include "ui/window/lesson/handout_saver.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "ui/window/lesson/handout.h"
#include "ui/window/main/picture_files.h"

namespace asperity {

HandoutSaver::HandoutSaver(QWidget* window) : QObject(window), window_(window) {}

void HandoutSaver::ask(const Lesson& lesson, const QString& name) {
  QMessageBox box(QMessageBox::Question, tr("Handout"),
                  tr("A handout for students has the questions; one for teachers has the answers "
                     "and the notes, too."),
                  QMessageBox::Cancel, window_);
  box.setObjectName("handoutQuestion");
  auto* students = box.addButton(tr("For &students"), QMessageBox::AcceptRole);
  auto* teachers = box.addButton(tr("For &teachers"), QMessageBox::AcceptRole);
  box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
  box.setDefaultButton(students);
  box.exec();
  if (box.clickedButton() != students && box.clickedButton() != teachers) return;
  const bool forTeacher = box.clickedButton() == teachers;
  const QString proposed = name + (forTeacher ? "_teacher.pdf" : ".pdf");
  const QString file =
      askSaveFile(window_, tr("Save handout"), proposed, tr("PDF (*.pdf);;Web page (*.html)"));
  if (!file.isEmpty()) save(lesson, file, forTeacher);
}

void HandoutSaver::save(const Lesson& lesson, const QString& file, bool forTeacher) {
  if (isSaving_) return;
  isSaving_ = true;
  emit savingChanged();
  emit statusChanged(tr("The program draws the pictures and computes the answers…"));
  work_.request(
      [lesson, file, forTeacher](const BackgroundWork::Run& run) {
        HandoutOptions options;
        options.forTeacher = forTeacher;
        options.stop = run.stop();
        writeHandout(file.toStdString(), lesson, options);
      },
      [this, file] {
        end(tr("Saved %1").arg(QFileInfo(file).fileName()));
        emit saved(file);
      },
      [this](const QString& reason) { end(reason); });
}

void HandoutSaver::end(const QString& text) {
  isSaving_ = false;
  emit savingChanged();
  emit statusChanged(text);
}

}  // namespace asperity
