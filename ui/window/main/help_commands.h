// The commands about the program itself: the guide, the list of shortcuts, version and model. Owned
// by the main window; GUI thread. Failure: the message bar shows why the guide cannot be opened.
#pragma once

#include <QObject>
#include <QString>

#include "ui/language/language.h"

class QMainWindow;

namespace asperity {

class Commands;
class MessageBar;

class HelpCommands : public QObject {
  Q_OBJECT

 public:
  HelpCommands(QMainWindow& window, MessageBar& messages);

  void addTo(Commands& commands);

  /// Opens the guide at an anchor ("eq-11"), or at its beginning.
  void openGuide(const QString& anchor);

 private:
  void showShortcuts();
  void showAbout();

  QMainWindow& window_;
  MessageBar& messages_;
};

/// Returns the guide of the program in this folder: one HTML file that is installed beside the
/// program, or made in its build folder; empty where there is none.
QString guideFile(const QString& programFolder);

/// Opens the guide in the reader's own browser, at an anchor or at its beginning. Returns the error
/// message; empty on success.
LiveText openGuideFile(const QString& programFolder, const QString& anchor = {});

}  // namespace asperity
