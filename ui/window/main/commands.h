// The commands of the window: each is an action with a name, a text in the language of the window,
// keys, and optionally a drawn icon. The parts of the window add their commands; menus and tool bar
// (main_menus.h) order them by name. GUI thread. Cannot fail.
#pragma once

#include <QAction>
#include <QColor>
#include <QIcon>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>

class QMainWindow;
class QMenu;

namespace asperity {

/// The icons of commands. None: a command without an icon.
enum class Symbol {
  Play,
  Pause,
  Step,
  Reset,
  Scenes,
  Figures,
  Open,
  Save,
  Undo,
  Redo,
  Light,
  None
};

/// Draws the icon in a colour, for screens of any density.
QIcon symbolIcon(Symbol symbol, const QColor& colour);

struct Command {
  std::string name;               // object name of the action
  std::function<QString()> text;  // called again for another language, and by refresh()
  std::function<void()> run;
  QList<QKeySequence> keys{};
  Symbol symbol = Symbol::None;
  std::function<QString()> button{};  // text on the tool bar; none: as in the menu
};

class Commands : public QObject {
 public:
  explicit Commands(QMainWindow& window);

  /// Adds a command, whose keys work in the whole window.
  QAction* add(Command command);

  /// Gives a command a tooltip that describes it, in place of its text.
  void setTip(const std::string& name, std::function<QString()> tip);

  /// Returns a command that was added; the name must be correct.
  QAction* get(const std::string& name) const;
  QList<QAction*> get(std::initializer_list<const char*> names) const;

  /// Updates a text that depends on more than the language.
  void refresh(const std::string& name);
  void setSymbol(const std::string& name, Symbol symbol);

  /// Draws all icons in this colour.
  void setColour(const QColor& colour);

 private:
  struct Entry {
    QAction* action;
    Command command;
    std::function<QString()> tip{};
  };
  void showText(const Entry& entry) const;
  void paint(const Entry& entry) const;

  QMainWindow& window_;
  std::map<std::string, Entry> entries_;
  QColor colour_;
};

/// Adds to a menu without entries one that gives the reason, and cannot be chosen.
void explainEmpty(QMenu& menu, const QString& reason);

/// Returns a text for a button: without dots.
QString buttonText(QString text);

}  // namespace asperity
