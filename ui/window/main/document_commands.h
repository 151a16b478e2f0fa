// The commands of the document: opening, saving, undo and redo; the list of recent files; and the
// question before the end of the program where changes of a file would be lost. Opening another
// scene is a step of the history, so it asks nothing. Owned by the main window; GUI thread.
// Failure: the reason appears in the message bar, and the document stays as it is.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QMenu;
class QWidget;

namespace asperity {

class Commands;
class MessageBar;
class ParameterPanel;
struct FoundScene;

class DocumentCommands : public QObject {
  Q_OBJECT

 public:
  /// `panel`: saving fails while an entry typed there is invalid.
  DocumentCommands(SceneDocument& document, const ParameterPanel& panel, MessageBar& messages,
                   QWidget& window);

  void addTo(Commands& commands);
  /// Adds a submenu of the recent files.
  void addRecentMenu(QMenu& menu);

  /// Reads a scene file, or any file that the program wrote from one, in the background, and shows
  /// its scene as showFound() does; where the file cannot be read, the message bar shows the
  /// reason. A newer call, or another scene, cancels the reading. A lesson, or results of one, only
  /// cause lessonFound(), at once.
  void openFile(const QString& file);
  /// Shows a scene that was read from a file. Asks first where the scene comes from a picture, film
  /// or table and would read another file, or needs very much memory or time.
  void showFound(const QString& file, const FoundScene& found);
  /// Returns false, with the reason in the message bar, where the file cannot be written.
  bool saveTo(const QString& file);

  /// Asks about each file whose changes would be lost at the end of the program. Returns whether
  /// the window may close: every file is as it was, has just been saved, or the user discards its
  /// changes, which then also are not kept for the next start.
  bool canClose();

 signals:
  /// Emitted instead of opening a file that is a lesson, or a student's results of one.
  void lessonFound(const QString& file);
  /// Emitted when the scene was saved to this file.
  void saved(const QString& file);

 private:
  bool confirmOpen(const QString& file, const FoundScene& found);
  bool save();
  bool askSave();
  bool write(const QString& file, const Scene& scene);
  bool maybeSave(const SceneState& state);
  void askOpen();
  void fillRecent();
  void showHistory();

  SceneDocument& document_;
  const ParameterPanel& panel_;
  MessageBar& messages_;
  QWidget& window_;
  Commands* commands_ = nullptr;
  QMenu* recent_ = nullptr;
  BackgroundWork reading_;  // last: its thread ends before other members are destroyed
};

/// The recent files, the newest first, as absolute paths, kept in the user's settings. Files that
/// no longer exist are left out.
inline constexpr int kMaxRecentFiles = 8;
QStringList recentFiles();
void addRecentFile(const QString& file);
void clearRecentFiles();

}  // namespace asperity
