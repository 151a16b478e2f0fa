// The tab of the map: friction over two parameters that are chosen, around the present scene. The
// map is computed in the background while the tab is visible, coarse first; a newer request stops
// the older one. Where only the two parameters change, the map stays and its cross moves. A scene
// with a target accuracy has a map of its stated number of lines, because all cells have the same
// lines, as a message of the panel states. GUI thread; owned by its parent. Failure: a line of the
// panel gives the reason.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/friction/parameter_map.h"
#include "ui/language/language.h"
#include "ui/window/tasks/background_work.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace asperity {

class ChoiceBox;
class MapView;

class MapPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MapPanel(QWidget* parent = nullptr);

  void showScene(const Scene& scene);

  MapView& view() { return *view_; }
  /// Returns the map that is shown; null before the first one.
  std::shared_ptr<const ParameterMap> map() const { return map_; }

 signals:
  /// Emitted with the scene at the cross, while this is dragged.
  void sceneEdited(const asperity::Scene& scene);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTexts();
  void fillChoosers();
  bool isCoveredBy(const ParameterMap& map) const;
  void compute();
  void request(const MapAxis& x, const MapAxis& y);
  void take(ParameterMap map);
  void showMap();
  void showCross();
  void moveTo(double x, double y);
  QString readingAt(double x, double y) const;
  void showTarget();
  void showMessage(const LiveText& text, const LiveText& tip = {});
  void updateMessage();
  void showProgress();
  void showTips();
  void fitRow();
  QString quantity() const;

  Scene scene_;        // without its target accuracy
  double target_ = 0;  // of the document: the relative error; 0: none
  bool hasScene_ = false;
  QHBoxLayout* row_;  // of the lists
  ChoiceBox *x_, *y_, *quantity_;
  QLabel *quantityLabel_, *message_, *progressLabel_;
  LiveText messageText_, messageTip_;
  QPushButton* save_;
  QStackedWidget* end_;  // of the row: the button or, while it computes, the progress
  MapView* view_;
  std::shared_ptr<const ParameterMap> map_;
  std::optional<ParameterMap> requested_;  // without points: axes and scene of the newest request
  std::int64_t lines_ = 0;                 // of the means of the newest request; 0: not known yet
  int percent_ = 0;                        // of these means that is computed
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
