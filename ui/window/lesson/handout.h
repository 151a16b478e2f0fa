// Handouts of lessons on paper and as a web page (handout_content.h), and the dialogs that save
// them. A handout is one file without links; it has the same bytes for the same lesson and
// language. Threading: the functions run on any thread on which no OpenGL context of the window is
// current, with a Qt application; HandoutSaver belongs to the GUI thread. Failure: InputError for
// another extension than .html or .pdf, or a scene that cannot run; std::runtime_error where it
// cannot be written; StopRequested where it was stopped. HandoutSaver reports one sentence by
// statusChanged().
#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QWidget>
#include <filesystem>

#include "ui/language/language.h"
#include "ui/window/lesson/handout_content.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

/// Returns a page of HTML with its pictures in it.
QByteArray handoutHtml(const Lesson& lesson, const HandoutOptions& options = {});

/// Returns the same as PDF on A4.
QByteArray handoutPdf(const Lesson& lesson, const HandoutOptions& options = {});

/// Writes HTML or PDF, by the extension.
void writeHandout(const std::filesystem::path& file, const Lesson& lesson,
                  const HandoutOptions& options = {});

/// Saves the handout of a lesson: dialogs over a page choose its readers and its file, and it is
/// written in the background, also where the page closes meanwhile. Owned by the window of the
/// page.
class HandoutSaver : public QObject {
  Q_OBJECT

 public:
  explicit HandoutSaver(QWidget* page);

  /// Asks, and saves unless that is cancelled. name: of the file, without its extension.
  void ask(const Lesson& lesson, const QString& name);
  /// Saves without a question; nothing happens while another handout is being saved.
  void save(const Lesson& lesson, const QString& file, bool forTeacher);
  bool isSaving() const { return work_.isBusy(); }

 signals:
  /// Emitted when saving begins and ends: the handout is being made, is saved, or cannot be saved.
  void statusChanged(const asperity::LiveText& text);
  /// Emitted when saving ends after the page was closed.
  void endedWithoutPage(const asperity::LiveText& text);

 private:
  void showStatus(const LiveText& status);

  QPointer<QWidget> page_;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
