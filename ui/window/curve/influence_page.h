// The page of influences on friction at the state of the scene: a diagram of the change with each
// parameter, or of the share of each wavelength of the roughness. It is computed in the background
// while the page is visible. GUI thread; owned by its parent. Failure: the reason is shown instead
// of the diagram.
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/chart/diagram.h"
#include "core/scene/scene.h"
#include "ui/language/language.h"
#include "ui/window/tasks/background_work.h"

class QLabel;

namespace asperity {

class ChoiceBox;
class DiagramView;

class InfluencePage : public QWidget {
  Q_OBJECT

 public:
  explicit InfluencePage(QWidget* parent = nullptr);

  void showScene(const Scene& scene);
  DiagramView& view() { return *view_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showTexts();
  void compute();
  void showResult(const DiagramSheet& sheet, const std::string& table);
  void showFailure(const LiveText& reason);
  void showProgress();
  bool showsWaves() const;
  int heightFor(const DiagramSheet& sheet) const;

  ChoiceBox* choice_;
  QLabel* hint_;
  DiagramView* view_;
  std::optional<Scene> scene_;
  std::optional<Scene> shown_;  // what the diagram belongs to, with `shownWaves_`
  bool shownWaves_ = false;
  int percent_ = 0;      // of the computation that is done
  Message note_{};       // of the diagram
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
