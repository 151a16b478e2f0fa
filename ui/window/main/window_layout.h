// How the window is laid out: the dock of parameters, the split between contact and tabs, full
// screen, and a presentation for an audience; how it is kept from one start to the next, and that
// all of it lies on the screen. Owned by the main window; GUI thread. Cannot fail.
#pragma once

#include <QByteArray>
#include <QFont>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QSize>
#include <optional>
#include <utility>

class QDockWidget;
class QMainWindow;
class QMenu;
class QSplitter;

namespace asperity {

class Appearance;
class Commands;
class ContactCanvas;
class FigurePages;
class SceneTabs;

/// Set by hand, because otherwise what the contents need for a moment, in large letters or under a
/// comparison, would push the window over the edge of the screen for good.
inline constexpr QSize kLeastWindow{900, 560};

struct LayoutParts {
  QMainWindow& window;
  QDockWidget& dock;    // of the parameters
  QSplitter& splitter;  // between contact and tabs
  ContactCanvas& canvas;
  SceneTabs& tabs;
  FigurePages& figures;
  Appearance& appearance;
};

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  explicit WindowLayout(const LayoutParts& parts);
  ~WindowLayout() override;

  void addTo(Commands& commands);
  void fillMenu(QMenu& menu);

  /// Restores size, docks, tabs and colours from the settings, as far as the screen has room for
  /// them. From then on closing the window saves its own. Call before the window is shown.
  void remember();
  /// Saves them to the settings when the window closes, if remember() was called.
  void save();

  /// Makes the present layout the one that restoreDefault() goes back to.
  void keepAsDefault();
  void restoreDefault();

  /// All of the window lies on its screen, as does what a maximized or full window goes back to.
  /// Call before it is shown.
  void fitToScreen();

  /// Shows contact and curve alone on the whole screen, with large texts, for an audience; Escape
  /// leaves.
  void setPresenting(bool presenting);
  bool isPresenting() const { return presentation_.has_value(); }

 private:
  void beginPresentation();
  void endPresentation();
  void setFullScreen(bool full);
  void showScreenMode();
  void makeRoomForFigures(bool areShown);

  LayoutParts parts_;
  Commands* commands_ = nullptr;
  bool remembers_ = false;
  QByteArray default_;
  bool hadDock_ = true, hadStatus_ = true;  // before the figures were opened
  /// The state to which the end of the presentation goes back.
  struct Presentation {
    QFont font;
    QByteArray geometry, docks;
    QSize dock;
    QList<std::pair<QPointer<QSplitter>, QByteArray>> splits;
    bool hasStatus;
  };
  std::optional<Presentation> presentation_;
};

}  // namespace asperity
