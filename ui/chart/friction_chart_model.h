// The model of the window's friction chart: it collects the runner's results and makes the diagram
// that files get, too (core/chart/curve_diagram.h), with a marker at the present velocity and axes
// that stay fixed while lines arrive. It remembers whether its curve belongs to an older scene (the
// curve is then drawn faded and never mixed with the new one), keeps pinned curves unchanged, and
// compares two settings. Owned by the session; one thread. Cannot fail.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/chart/curve_diagram.h"
#include "core/run/frame.h"
#include "core/run/runner.h"
#include "ui/chart/chart_geometry.h"

namespace asperity {

/// Returns whether two scenes have the same averaged curve: they agree in all but titles and
/// motion.
bool haveSameCurve(const Scene& a, const Scene& b);

/// A curve that stays while the scene changes.
struct PinnedCurve {
  int id = 0;           // above 0, never reused
  int colourIndex = 0;  // lowest free number; it determines colour and mark
  std::shared_ptr<const CurveUpdate> curve;
};

class FrictionChartModel {
 public:
  /// Announces the scene that was posted. Its velocities are in the range at once; the present
  /// curve is stale unless it belongs to that scene, too.
  void expect(const Scene& scene);

  /// Takes a later state of a curve. It is ignored if it does not belong to the expected scene or
  /// has no point yet. Returns whether it is shown.
  bool take(const CurveUpdate& update);

  /// Marks the position of this frame on the curve. Returns whether the marker lies within the
  /// present axes.
  bool mark(const Frame& frame);
  /// Removes the marker: the scene cannot be computed.
  void unmark() { marker_ = dimensionlessMarker_ = std::nullopt; }
  /// Lets the next curve choose the vertical axis: after another scene was opened, the decades of
  /// the one before are only empty.
  void resetAxes() { resetsAxes_ = true; }
  /// Fits the vertical axis to what is shown now, without the decades of earlier curves.
  void fitVerticalAxis();
  /// Fades the marker while it belongs to the previous scene. Returns whether that changes it.
  bool fadeMark(bool fades) { return std::exchange(isMarkFaded_, fades) != fades; }

  void setAxes(CurveAxes axes);
  CurveAxes axes() const { return axes_; }
  /// Sets what the vertical axis shows, and whether it is linear. Another quantity has no marker
  /// before the next call of mark().
  void setQuantity(CurveQuantity quantity);
  CurveQuantity quantity() const { return quantity_; }
  void setLinearY(bool isLinear);
  bool isLinearY() const { return isLinearY_; }

  /// Hides the present curve and everything that reveals it, with these ends of the vertical axis,
  /// while a student predicts it; none: shows it. Pinned curves stay.
  void conceal(std::optional<AxisRange> ends) { concealed_ = ends; }
  bool isConcealed() const { return concealed_.has_value(); }
  /// Lets the vertical axis reach over these values, too, until another quantity is shown or the
  /// axis is fitted: a guess stays in sight beside the curve. None: over the curves alone.
  void reachOver(std::optional<AxisRange> values) { reach_ = values; }

  /// Pins the present curve. Returns its number, or 0 where there is none or it is pinned already.
  int pin();
  /// Pins another curve over the same key.
  int pin(std::shared_ptr<const CurveUpdate> curve);
  void unpin(int id);
  void unpinAll();
  const std::vector<PinnedCurve>& pinned() const { return pinned_; }
  /// Returns the differences from the present scene: "G = 20 MPa".
  QString pinnedName(const PinnedCurve& pinned) const;

  /// Sets the difference of two settings, shown below while it belongs to this curve; none: no
  /// strip.
  void showDifference(std::optional<CurveDifference> difference);
  /// Sets the theories and the measured friction of this scene. While those of another scene with
  /// the same tables are computed, measured points stay, placed on its axis; ratios to what was
  /// computed and theories are then faded.
  void showComparisons(const Scene& scene, CurveSet comparisons);
  const std::optional<CurveDifference>& difference() const { return difference_; }
  /// Returns whether the difference belongs to another curve than the present scene's.
  bool isDifferenceStale() const;

  bool isStale() const;
  /// Returns whether there is a curve over the present axis.
  bool hasCurve() const { return curve_ && isOnThisAxis(*curve_->scene); }
  /// Returns the finished part of the present scene's curve, 0 to 1. It is 1 only for a complete
  /// curve, because a target accuracy may need more lines at any time.
  double progress() const;

  DiagramSheet sheet() const;
  std::optional<DiagramMarker> marker() const;

  /// These functions return the reading of a point of the sheet, and its value of the swept key
  /// (velocity: m/s); empty where there is none.
  QString describe(int id, int row) const;
  std::optional<double> sweptValue(int id, int row) const;
  /// Returns the value of the swept key at a position on the axis; empty where there is none.
  std::optional<double> sweptAt(double x) const;

  /// Returns the curves in the visible range, for writing them; nothing before the first curve.
  /// Faded theories and ratios, which belong to the scene before, are left out.
  std::optional<CurveSet> shown(const std::optional<VisibleRange>& zoom) const;

 private:
  Message englishName(const PinnedCurve& pinned, const Scene& present) const;
  const Scene& present() const { return expected_ ? *expected_ : *curve_->scene; }
  CurveSet unnamedCurves() const;
  CurveSet curvesBeside(const Scene& present) const;
  CurveSet curves() const { return curve_ ? curvesBeside(present()) : view(); }
  /// Adds the theories and the measured friction as they belong to the set's present curve.
  void addComparisons(CurveSet& set) const;
  bool areComparisonsStale() const;
  /// Returns the axes without curves.
  CurveSet view() const;
  bool isOnThisAxis(const Scene& scene) const;
  Message status() const;
  void fitRanges(bool newCurve);
  AxisRange neededYRange(const AxisRange& data) const;

  std::optional<Scene> expected_;
  std::shared_ptr<const CurveUpdate> curve_;
  std::vector<PinnedCurve> pinned_;
  int lastId_ = 0;
  std::optional<CurveDifference> difference_;
  std::optional<Scene> compared_;  // the scene of the comparisons
  CurveSet comparisons_;           // its theories and measured curves
  CurveAxes axes_ = CurveAxes::Physical;
  CurveQuantity quantity_ = CurveQuantity::Mu;
  bool isLinearY_ = false;
  std::string sweptKey_{kVelocityKey};   // of the ranges below
  std::string markedKey_{kVelocityKey};  // of the marker
  std::optional<DiagramMarker> marker_, dimensionlessMarker_;
  double markerFactor_ = 1;    // from m/s to the dimensionless axis, for the frame's line
  double fastest_ = 0;         // m/s, of the marked motion
  bool awaitsMarker_ = false;  // a new curve is there, and its scene's first picture may not be
  bool isMarkFaded_ = false;
  bool isMarkSettled_ = false;  // of the steady state, to which the picture still moves
  bool resetsAxes_ = false, resetsAxesWithMark_ = false;  // with the next curve; with its marker
  std::optional<AxisRange> concealed_;                    // ends of the vertical axis
  std::optional<AxisRange> reach_;                        // values that it contains
  AxisRange xRange_, yRange_;                             // decades, or values of a linear axis
};

}  // namespace asperity
