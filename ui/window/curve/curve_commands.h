// The commands of the friction diagram: pins, axes, view, files. Each is an action with a name and,
// where it has one, a key. GUI thread; owned by its parent. Failure: the message bar shows the
// reason.
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/scene/parameters.h"
#include "ui/window/tasks/background_work.h"

class QAction;
class QMenu;

namespace asperity {

class ChartView;
class Exports;
class MessageBar;
class Session;

/// Computes the whole curves of some scenes in the background, and then pins them. scenes: called
/// on the worker's thread.
void pinCurves(Session& session, BackgroundWork& work, std::function<std::vector<Scene>()> scenes,
               BackgroundWork::Failed failed);

class CurveCommands : public QObject {
  Q_OBJECT

 public:
  CurveCommands(Session& session, ChartView& view, Exports& exports, MessageBar& messages,
                QObject* parent);

  /// Adds all commands to the menu, and most of them to the view's context menu; call it once.
  void fill(QMenu& menu);

  /// Returns the curves as they are shown; nothing before the first.
  std::optional<CurveSet> shown() const;

  /// Returns the numbers that can be the horizontal axis, velocity first.
  std::vector<const Parameter*> axisKeys() const;
  /// Makes the key the axis, over a range around its own value; null: the dimensionless velocity.
  void chooseAxis(const Parameter* parameter);
  /// Chooses what the vertical axis shows; the axes then have units.
  void chooseQuantity(CurveQuantity quantity);
  bool hasDimensionlessAxes() const;

  /// Saves PNG, SVG, PDF or CSV, by the extension.
  void save(const QString& file);

 signals:
  /// Emitted when another axis was chosen.
  void axisChosen(const asperity::Scene& scene);
  /// Emitted when the user requests the guide about the object under the pointer.
  void guideRequested(const QString& anchor);

 private:
  /// Returns a text in the language of the window.
  using Text = QString (*)();
  QAction* add(const char* name, Text text, std::function<void()> run, Text tip = nullptr);
  void fillUnpin();
  void showState();
  void askSave();
  void copyPicture();
  void setAxes(bool dimensionless);
  void fillKeys(QMenu& menu, std::function<void(const Parameter&)> choose, bool withVelocity);
  void addFamilySizes();
  void fillQuantities();
  void spaceEvenly(bool isLinear);
  void pinFamily(const Parameter& parameter);

  Session& session_;
  ChartView& view_;
  Exports& exports_;
  MessageBar& messages_;
  QAction *pin_, *unpinAll_, *dimensionless_, *nearer_, *farther_, *fit_, *save_, *copy_, *guide_;
  QAction *linearX_, *linearY_;
  QMenu* unpin_ = nullptr;
  QMenu *keys_ = nullptr, *quantities_ = nullptr, *family_ = nullptr;
  int familySize_ = 5;
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
