// The plan of a scene as a list: each stage in order, whether it runs, and why. Effects that
// exclude each other are reported in a single line. It is filled only while it is visible, so that
// a drag of a slider does not wait for it. GUI thread; owned by its parent.
#pragma once

#include <QTreeWidget>

#include "core/scene/scene.h"

namespace asperity {

class PlanList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit PlanList(QWidget* parent = nullptr);

  void showScene(const Scene& scene);

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void refill();
  void fill();
  void fitColumns();
  void fitRows();

  Scene scene_;
  bool isFilled_ = false;
};

}  // namespace asperity
