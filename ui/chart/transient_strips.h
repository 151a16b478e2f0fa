// What a motion that is not steady does in time, as three strips over one axis of time: friction
// with the predicted relaxation over it, indentation, mean contact length. Grows while the motion
// runs. GUI thread; belongs to its parent. Cannot fail: what is not a number is left out.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "core/run/minimum_span.h"
#include "core/run/transient_sample.h"
#include "core/scene/scene.h"
#include "ui/chart/plot_view.h"

namespace asperity {

class TransientStrips : public QWidget {
  Q_OBJECT

 public:
  explicit TransientStrips(QWidget* parent = nullptr);

  /// samples: as a frame has them; null: nothing to show. spacing, period: of the line, m, so that
  /// its ripple is not magnified (core/run/minimum_span.h).
  void show(const Sliding& sliding, std::shared_ptr<const std::vector<TransientSample>> samples,
            double spacing = 0, double period = 0);
  void setColours(const PlotColours& colours);

  /// "predicted rate 1/τ + v/ℓ = 2.1×10³ s⁻¹ ...", of the newest sample, where its relaxation is
  /// drawn; empty where there is nothing to say.
  QString note() const;
  std::size_t sampleCount() const { return samples_ ? samples_->size() : 0; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  using Line = std::vector<QPointF>;  // time (s) and value
  bool hasGuide() const { return guide_.size() > 1; }
  Line lineOf(const std::function<double(const TransientSample&)>& value) const;
  void paintLegend(QPainter& painter, const QRectF& room) const;
  void paintStrip(QPainter& painter, const QRectF& room, const char* unit, const Line& line,
                  const Line& guide, double least) const;
  double nameWidth(const QStringList& names) const;
  QRectF nameRoom(const QRectF& strip) const;
  void paintValues(QPainter& painter, const QRectF& room, const char* unit, const AxisEnds& ends,
                   const std::function<double(double)>& yOf) const;
  void paintTimes(QPainter& painter, const QRectF& room) const;

  Sliding sliding_;
  double spacing_ = 0, period_ = 0;  // m
  std::shared_ptr<const std::vector<TransientSample>> samples_;
  Line guide_;
  PlotColours colours_;
};

}  // namespace asperity
