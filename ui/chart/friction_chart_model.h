// The friction curve of the window: collects what the runner delivers and says what to show, as the
// same diagram that files get (core/chart/curve_diagram.h) with the marker of the present velocity
// and axes that hold still while lines arrive. Knows when the curve at hand belongs to an older
// scene (then it is drawn faded and never mixed with the new one), keeps pinned curves as they
// were, and compares two settings. Owned by the session; one thread. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/chart/curve_diagram.h"
#include "core/run/frame.h"
#include "core/run/runner.h"
#include "ui/chart/chart_geometry.h"

namespace asperity {

/// Whether two scenes have the same averaged curve: all but titles and motion agree.
bool haveSameCurve(const Scene& a, const Scene& b);

/// The whole decades around [low, high]; both positive and finite.
AxisRange decadesAround(double low, double high);

/// The range to show next. It grows at once where the data need it, and shrinks only when
/// `mayShrink` and an end lies two decades or more outside the data.
AxisRange steadyRange(const AxisRange& shown, const AxisRange& needed, bool mayShrink);

/// A few digits for reading, not for computing, as everywhere: shortNumber() of ui/draw.
QString readingLabel(double value, int digits = 3);

/// A curve that stays while the scene changes.
struct PinnedCurve {
  int id = 0;     // above 0, never used again
  int place = 0;  // the lowest that was free: decides colour and mark
  std::shared_ptr<const CurveUpdate> curve;
};

class FrictionChartModel {
  Q_DECLARE_TR_FUNCTIONS(asperity::FrictionChartModel)

 public:
  /// A scene was posted: its velocities are in the range at once; the curve at hand is stale unless
  /// it is that scene's, too.
  void expect(const Scene& scene);

  /// A later state of a curve. Ignored when it is not of the expected scene or has no point yet.
  /// Returns whether it is shown.
  bool take(const CurveUpdate& update);

  /// Marks where this frame is on the curve. Returns whether the axes hold the marker as they are.
  bool mark(const Frame& frame);
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
  const std::optional<CurveDifference>& difference() const { return difference_; }
  /// Whether it is of another curve than the present scene's.
  bool isDifferenceStale() const;

  bool isStale() const;
  bool hasCurve() const { return curve_ != nullptr; }
  /// Returns the finished part of the present scene's curve, 0 to 1. It is 1 only for a complete
  /// curve, because a target accuracy may need more lines at any time.
  double progress() const;

  DiagramSheet sheet() const;
  std::optional<DiagramMarker> marker() const;

  /// The reading of a point of the sheet, and its velocity (m/s); empty where there is none.
  QString describe(int id, int row) const;
  std::optional<double> velocityOf(int id, int row) const;
  /// m/s, of a place on the axis; empty where it has none.
  std::optional<double> velocityAt(double x) const;

  /// What is shown in this window, to be written; nothing before the first curve.
  std::optional<CurveSet> shown(const std::optional<VisibleRange>& zoom) const;

 private:
  const CurveUpdate* find(int id) const;
  QString reading(const CurvePoint& point) const;
  QString reading(const DifferencePoint& point) const;
  Message englishNameOf(const PinnedCurve& pinned, const Scene& present) const;
  const Scene& present() const { return expected_ ? *expected_ : *curve_->scene; }
  CurveSet curves(const Scene& present) const;
  Message status() const;
  void fitRanges(bool newCurve);
  AxisRange neededCoefficients(const AxisRange& data) const;

  std::optional<Scene> expected_;
  std::shared_ptr<const CurveUpdate> curve_;
  std::vector<PinnedCurve> pinned_;
  int lastId_ = 0;
  std::optional<CurveDifference> difference_;
  CurveAxes axes_ = CurveAxes::Physical;
  std::optional<DiagramMarker> marker_, dimensionlessMarker_;
  double markerFactor_ = 1;  // of the frame's line, from m/s to the dimensionless axis
  double fastest_ = 0;       // m/s, of the marked motion
  bool isMarkFaded_ = false;
  AxisRange velocities_, coefficients_;  // decades
};

}  // namespace asperity
