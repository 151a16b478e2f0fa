// The diagram of friction coefficient against velocity: collects what the runner delivers and says
// what to show. Knows when the curve at hand belongs to an older scene (then it is drawn faded and
// never mixed with the new one), keeps pinned curves as they were, and compares two settings.
// Owned by the session; one thread. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/run/frame.h"
#include "core/run/runner.h"
#include "ui/chart/friction_series.h"
#include "ui/chart/plot.h"

namespace asperity {

/// A curve that stays while the scene changes.
struct PinnedCurve {
  int id = 0;     // above 0, never used again
  int place = 0;  // the lowest that was free: decides colour and mark
  std::shared_ptr<const CurveUpdate> curve;
};

class FrictionPlot {
  Q_DECLARE_TR_FUNCTIONS(asperity::FrictionPlot)

 public:
  /// A scene was posted: its velocities are in the range at once; the curve at hand is stale unless
  /// it is that scene's, too.
  void expect(const Scene& scene);

  /// A later state of a curve. Ignored when it is not of the expected scene or has no point yet.
  /// Returns whether it is shown.
  bool take(const CurveUpdate& update);

  /// The velocity of this frame and the steady friction of its line; of a motion the magnitude of
  /// its velocity at the moment, its friction then, and both since it began.
  void mark(const Frame& frame);
  /// What is marked is of the scene before, as the present one takes its time.
  void fadeMark(bool fades) { isMarkFaded_ = fades; }

  void setAxes(CurveAxes axes);
  CurveAxes axes() const { return axes_; }

  /// Keeps the curve at hand. Returns its number, or 0 where there is none or it is kept already.
  int pin();
  void unpin(int id);
  void unpinAll();
  const std::vector<PinnedCurve>& pinned() const { return pinned_; }
  /// "G = 20 MPa": in what it differs from the present scene.
  QString nameOf(const PinnedCurve& pinned) const;

  /// The difference of two settings, shown below while it is of this curve; none: no strip.
  void showDifference(std::optional<CurveDifference> difference);

  bool isStale() const;
  bool hasCurve() const { return curve_ != nullptr; }
  /// Of the present scene's curve, 0 to 1; 1 only where it is complete, because a target may ask
  /// for more lines at any time.
  double progress() const;
  Plot plot() const;
  std::optional<PlotMarker> marker() const;

  /// The reading of a point of the plot, and its velocity (m/s); empty where there is none.
  QString describe(int id, int row) const;
  std::optional<double> velocityOf(int id, int row) const;
  /// m/s, of a place on the axis; empty where it has none.
  std::optional<double> velocityAt(double x) const;

  /// What is shown in this window, to be written; nothing before the first curve.
  std::optional<CurveSet> shown(const std::optional<PlotWindow>& zoom) const;

 private:
  const CurveUpdate* find(int id) const;
  bool hasStaleDifference() const;
  QString note() const;
  QString blank() const;
  void fitRanges(bool newCurve);
  DecadeRange neededCoefficients(const DecadeRange& data) const;
  void markMotion(const Frame& frame);

  std::optional<Scene> expected_;
  std::shared_ptr<const CurveUpdate> curve_;
  std::vector<PinnedCurve> pinned_;
  int lastId_ = 0;
  std::optional<CurveDifference> difference_;
  CurveAxes axes_ = CurveAxes::Physical;
  std::optional<PlotMarker> marker_;  // on physical axes
  AxesFactors markerFactors_{1, 1};   // of the frame's line, to dimensionless ones
  double fastest_ = 0;                // m/s, of the marked motion
  bool isMarkFaded_ = false;
  DecadeRange velocities_, coefficients_;
};

}  // namespace asperity
