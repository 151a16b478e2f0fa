// The commands of the document: opening, saving, dropping a file on the window, undo and redo; and
// the question before unsaved changes would be lost. It keeps the list of recent files. Owned by
// the main window; GUI thread. Failure: the reason appears in the message bar, and the document
// stays as it is.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>

#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QDropEvent;
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
  /// `panel`: an invalid entry that is being typed there cannot be saved.
  DocumentCommands(SceneDocument& document, const ParameterPanel& panel, MessageBar& messages,
                   QWidget& window);

  void addTo(Commands& commands);
  /// Adds a submenu of the recent files.
  void addRecentMenu(QMenu& menu);

  /// Reads a scene file, or any file that the program wrote from one, in the background, and shows
  /// its scene as showFound() does; the newest call wins. sceneRead() follows; where the file
  /// cannot be read, the message bar shows the reason.
  void openFile(const QString& file);
  /// Shows a scene that was read from a file. Asks first where the scene comes from a picture, film
  /// or table and would read another file, or needs very much memory or time.
  void showFound(const QString& file, const FoundScene& found);
  /// Opens a file that was dropped on the window.
  void openDropped(const QString& file);

  /// Called before anybody is asked whether the present scene may be left: what stands in for the
  /// user's own scene gives it back.
  void setBeforeLeaving(std::function<void()> leave) { beforeLeaving_ = std::move(leave); }

  /// Returns false, with the reason in the message bar, where the file cannot be written.
  bool saveTo(const QString& file);

  /// Returns whether the document may be closed: it is unchanged, has just been saved, or the user
  /// discards it.
  bool mayLeave();
  /// Opens another document, if the present one may be closed.
  void replace(const SceneOrigin& origin);

 signals:
  /// Emitted when a requested file has been read, and its scene is shown or not.
  void sceneRead(const QString& file, bool isShown);

 private:
  bool mayShow(const QString& file, const FoundScene& found);
  bool save();
  bool askSave();
  void askOpen();
  void fillRecent();
  void showHistory();

  SceneDocument& document_;
  const ParameterPanel& panel_;
  MessageBar& messages_;
  QWidget& window_;
  Commands* commands_ = nullptr;
  QMenu* recent_ = nullptr;
  std::function<void()> beforeLeaving_;
  BackgroundWork reading_;  // last: its thread ends before other members are destroyed
};

/// The recent files, the newest first, as absolute paths, kept in the user's settings. Files that
/// no longer exist are left out.
inline constexpr int kMostRecentFiles = 8;
QStringList recentFiles();
void addRecentFile(const QString& file);
void clearRecentFiles();

}  // namespace asperity
