// The plan of a scene as a list to read: each stage in order, whether it runs, and why. GUI thread;
// belongs to its parent. Effects that exclude each other are said in the list's only line.
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

 private:
  void fill();
  void fitColumns();

  Scene scene_;
};

}  // namespace asperity
