// A motion in time: velocity, friction, indentation and length per contact as strips below each
// other and, for an oscillation, the loop of friction over velocity beside them. After the present
// moment the lines are faded. The pointer reads the nearest moment; a click on a strip goes there;
// a menu copies or saves either of them. GUI thread; owned by its parent.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/run/frame.h"
#include "core/scene/scene.h"

class QKeyEvent;

namespace asperity {

class ChartView;
class DiagramFiles;

class MotionView : public QWidget {
  Q_OBJECT

 public:
  explicit MotionView(QWidget* parent = nullptr);

  void showScene(const Scene& scene);
  void showFrame(const Frame& frame);

  ChartView& strips() { return *strips_; }
  ChartView& loop() { return *loop_; }
  /// Returns the sample at a position of the strips or the loop, in the pixels of that widget; none
  /// where the pointer is not near one.
  const TransientSample* sampleAt(const ChartView& chart, QPointF position) const;

  /// Returns what writes the strips or the loop: .png, .svg, .pdf, or .csv with all samples.
  DiagramFiles& stripFiles() { return *stripFiles_; }
  DiagramFiles& loopFiles() { return *loopFiles_; }

 signals:
  /// Emitted when a moment of the strips is clicked, s; it may be one that was not reached yet.
  void seekRequested(double time);
  /// Emitted when the arrow keys move the moment by this part of the motion; below 0 back.
  void stepRequested(double part);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Samples = std::shared_ptr<const std::vector<TransientSample>>;
  QString reading(const TransientSample& sample) const;
  bool step(const QKeyEvent& event);
  /// Returns the time at a position of the strips, s; nothing beside their frames.
  std::optional<double> momentAt(QPointF position) const;

  ChartView *strips_, *loop_;
  DiagramFiles *stripFiles_, *loopFiles_;
  Samples samples_, later_;         // up to the present moment, and those that are known after it
  double duration_ = 0;             // s
  std::optional<QPointF> pressed_;  // on the strips
};

}  // namespace asperity
