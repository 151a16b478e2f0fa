// The layout of the window: the dock of parameters, the split between contact and tabs, full
// screen, and a presentation for an audience. It is kept from one start to the next, and always
// lies on the screen. Owned by the main window; GUI thread. Cannot fail.
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
class QWidget;

namespace asperity {

class Appearance;
class Commands;
class ContactCanvas;
class WindowPages;
class MessageBar;
class ParameterPanel;
class SceneTabs;

/// The minimum size of the window. It is fixed, because a temporary need for space, from large
/// letters or a comparison, would otherwise push the window over the edge of the screen
/// permanently.
inline constexpr QSize kMinWindowSize{900, 560};

/// Pixels around a page that stay free for the frame of the window manager.
inline constexpr QSize kWindowFrame{40, 80};

/// Gives a page over the window its size: the usual one, more on a large screen, and never more
/// than a small one has.
void resizePage(QWidget& page, QSize usual);

/// Gives a dialog over the window its size, and never more than a small screen has.
void resizeDialog(QWidget& dialog, QSize usual);

struct LayoutParts {
  QMainWindow& window;
  QDockWidget& dock;  // of the parameters
  ParameterPanel& panel;
  QSplitter& splitter;  // between contact and tabs
  ContactCanvas& canvas;
  SceneTabs& tabs;
  WindowPages& pages;
  Appearance& appearance;
  MessageBar& messages;
  MessageBar& description;  // of the scene
  MessageBar& offer;        // of the tour, at a first start
};

class WindowLayout : public QObject {
  Q_OBJECT

 public:
  explicit WindowLayout(const LayoutParts& parts);
  ~WindowLayout() override;

  void addTo(Commands& commands);
  void fillMenu(QMenu& menu);

  /// Restores size, docks, tabs and colours from the settings, as far as they fit on the screen.
  /// From then on closing the window saves its layout, and colours are saved when the user chooses
  /// them. Call before the window is shown.
  void remember();
  bool remembers() const { return remembers_; }
  /// Saves the layout to the settings when the window closes, if remember() was called.
  void save();

  /// Makes the present layout the one that restoreDefault() goes back to.
  void keepAsDefault();
  void restoreDefault();

  /// Moves the window onto its screen, together with the normal size of a maximized or full-screen
  /// window. Call it before the window is shown.
  void fitToScreen();

  /// Shows the parameters and puts the cursor into their filter.
  void filterParameters();

  /// Shows contact and curve alone on the whole screen, with large texts, for an audience; Escape
  /// leaves.
  void setPresenting(bool presenting);
  bool isPresenting() const { return presentation_.has_value(); }

 protected:
  /// Watches the offer of the tour, and the size of the window.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void moveBorder(int down);
  void fitDescription();
  void beginPresentation();
  void endPresentation();
  void showPanelNote();
  void endPanelNote();
  void setFullScreen(bool full);
  void showScreenMode();
  void hideDocks(bool areViewsCovered);
  void fitDockToScreen();
  void saveTheme();
  bool restoreDocks(const QByteArray& state, int version = 0);

  LayoutParts parts_;
  Commands* commands_ = nullptr;
  bool remembers_ = false;
  QByteArray default_;
  bool hadDock_ = true, hadStatus_ = true;  // before the figures were opened
  /// The state before the presentation, which its end restores.
  struct Presentation {
    QFont font;
    QByteArray geometry, docks;
    QSize dock;
    QList<std::pair<QPointer<QSplitter>, QByteArray>> splits;
    bool hasStatus;
  };
  std::optional<Presentation> presentation_;
  bool hasPanelNote_ = false;      // the message bar shows how the parameters come back
  std::optional<QSize> dockSize_;  // the size that the dock gets back when the layouts allow it
};

}  // namespace asperity
