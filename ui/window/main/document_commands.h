// What a user does with the document: opening, saving, dropping a file on the window, undo and
// redo; and the question before something that is not saved would be lost. Knows the files that
// were opened or saved last. Owned by the main window; GUI thread. Failure: the reason appears in
// the bar of messages, and the document stays as it is.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

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
  /// `panel`: what is typed there and misses something cannot be saved.
  DocumentCommands(SceneDocument& document, const ParameterPanel& panel, MessageBar& messages,
                   QWidget& window);

  void addTo(Commands& commands);
  /// A submenu of the files that were opened or saved last.
  void addRecentMenu(QMenu& menu);

  /// Reads a scene file, or any file that the program wrote from one, in the background, and shows
  /// its scene as showFound() does; the newest call wins. sceneRead() follows; where the file does
  /// not read, with the reason in the message bar.
  void openFile(const QString& file);
  /// Shows a scene that was read from a file. Asks first where it comes out of a picture, film or
  /// table and would read a file elsewhere, or take very much memory or time.
  void showFound(const QString& file, const FoundScene& found);
  /// A file that was dropped on the window.
  void openDropped(const QString& file);

  /// False, with the reason in the message bar, where the file cannot be written.
  bool saveTo(const QString& file);

  /// Whether the document may go: it is unchanged, was saved just now, or nobody wants it.
  bool mayLeave();
  /// Another document, if this one may go.
  void replace(const SceneOrigin& origin);

 signals:
  /// A file that was to be opened was read, and its scene is shown or not.
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
  BackgroundWork reading_;  // last: its thread ends before anything else here goes
};

/// The files opened or saved last, the newest first, as absolute paths, kept in the user's
/// settings. Files that are not there any more are left out.
inline constexpr int kMostRecentFiles = 8;
QStringList recentFiles();
void addRecentFile(const QString& file);
void clearRecentFiles();

}  // namespace asperity
