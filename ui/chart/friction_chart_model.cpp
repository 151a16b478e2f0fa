#include "ui/chart/friction_chart_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_words.h"
#include "core/run/transient_diagram.h"
#include "core/scene/motion.h"
#include "core/scene/sweep.h"
#include "ui/chart/curve_ranges.h"
#include "ui/chart/point_text.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr AxisRange kEmptyVelocities{-5, 3};  // shown before anything is known
const AxisRange kEmptyCoefficients{std::log10(kEmptyFrictionFrom), std::log10(kEmptyFrictionTo)};

constexpr double kMarginFactor = 1.15;  // between friction and the ends of a logarithmic axis

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0;
}

bool hasKnownPoint(const CurveUpdate& update) {
  return std::any_of(update.points.begin(), update.points.end(), isKnown);
}

bool isOneLine(const CurveUpdate& curve) {
  return curve.realizationsTotal <= 1;
}

/// Returns "33 % of the curve". Over another key than velocity every value may have lines of its
/// own, whose number would not be that of the legend.
Message finishedPart(const CurveUpdate& curve) {
  const double part = static_cast<double>(curve.realizationsDone) /
                      static_cast<double>(std::max<std::int64_t>(curve.realizationsTotal, 1));
  return message("{} % of the curve", static_cast<int>(100 * part));
}

/// Returns the text for the progress of a curve while it is averaged.
Message progressText(const CurveUpdate& curve) {
  if (curve.isComplete) return {};
  if (!curve.scene->sweep.isOfVelocity()) return finishedPart(curve);
  return message("{} of {} lines", curve.realizationsDone, curve.realizationsTotal);
}

/// Returns the range that is needed; the one that is shown where none is known.
AxisRange knownRange(const AxisRange& needed, const AxisRange& shown) {
  return needed.isEmpty() ? shown : needed;
}

/// Removes what was computed for the scene of the comparisons. On an axis other than velocity, the
/// rows of the tables that are shown depend on that scene, too.
void clearComputedComparisons(CurveSet& set) {
  set.theories.clear();
  for (MeasuredCurve& measured : set.measured) measured.computed.clear();
  if (set.isOfVelocity()) return;
  set.measured.clear();
  set.notes.clear();
}

}  // namespace

bool haveSameCurve(const Scene& a, const Scene& b) {
  return canonicalCurveScene(a) == canonicalCurveScene(b);
}

void FrictionChartModel::expect(const Scene& scene) {
  expected_ = scene;
  const bool isOtherAxis = scene.sweep.key != sweptKey_;
  if (isOtherAxis) {
    sweptKey_ = scene.sweep.key;
    if (!scene.sweep.isOfVelocity()) axes_ = CurveAxes::Physical;
    xRange_ = yRange_ = {};
  }
  fitRanges(!curve_ || isOtherAxis);
}

bool FrictionChartModel::isStale() const {
  return curve_ && expected_ && !haveSameCurve(*curve_->scene, *expected_);
}

bool FrictionChartModel::take(const CurveUpdate& update) {
  if (!update.scene || !hasKnownPoint(update)) return false;
  if (expected_ && !haveSameCurve(*update.scene, *expected_)) return false;
  const bool newCurve = !curve_ || !haveSameCurve(*curve_->scene, *update.scene);
  curve_ = std::make_shared<const CurveUpdate>(update);
  awaitsMarker_ |= newCurve;
  if (newCurve && std::exchange(resetsAxes_, false)) {
    yRange_ = {};
    resetsAxesWithMark_ = true;
  }
  fitRanges(newCurve);
  return true;
}

bool FrictionChartModel::mark(const Frame& frame) {
  const std::pair before{xRange_, yRange_};
  marker_ = frameMarker(frame, CurveAxes::Physical, quantity_);
  isMarkSettled_ = frame.isSettling;
  markedKey_ = frame.scene->sweep.key;
  dimensionlessMarker_ = frameMarker(frame, CurveAxes::Dimensionless);
  markerFactor_ = axesFactors(frame, CurveAxes::Dimensionless).velocity;
  if (frame.transient) {
    const Motion motion(frame.scene->sliding);
    fastest_ = motion.fastest(0, motion.duration());
  }
  // A curve may come before the first picture of its scene: then the marker of the scene before has
  // widened the axes.
  const bool isItsMarker = awaitsMarker_ && haveSameCurve(*curve_->scene, *frame.scene);
  if (isItsMarker) awaitsMarker_ = false;
  if (isItsMarker && std::exchange(resetsAxesWithMark_, false)) yRange_ = {};
  fitRanges(isItsMarker);
  return before == std::pair{xRange_, yRange_};
}

void FrictionChartModel::fitVerticalAxis() {
  reach_.reset();
  yRange_ = {};
  fitRanges(true);
}

void FrictionChartModel::setAxes(CurveAxes axes) {
  if (axes == axes_) return;
  axes_ = axes;
  reach_.reset();
  xRange_ = yRange_ = {};
  fitRanges(true);
}

void FrictionChartModel::setQuantity(CurveQuantity quantity) {
  if (quantity == quantity_) return;
  quantity_ = quantity;
  comparisons_.theories.clear();  // those of the new quantity follow, and the marker
  marker_.reset();
  fitVerticalAxis();
}

void FrictionChartModel::setLinearY(bool isLinear) {
  if (isLinear == isLinearY_) return;
  isLinearY_ = isLinear;
  fitVerticalAxis();
}

bool FrictionChartModel::isOnThisAxis(const Scene& scene) const {
  return scene.sweep.key == sweptKey_;
}

CurveSet FrictionChartModel::view() const {
  CurveSet set;
  set.axes = axes_;
  set.y = axes_ == CurveAxes::Physical ? quantity_ : CurveQuantity::Mu;
  if (isLinearY_) set.yScale = AxisScale::Linear;
  if (expected_ || curve_) set.present.scene = present();
  return set;
}

int FrictionChartModel::pin() {
  return hasCurve() ? pin(curve_) : 0;
}

int FrictionChartModel::pin(std::shared_ptr<const CurveUpdate> curve) {
  for (const PinnedCurve& pinned : pinned_)
    if (haveSameCurve(*pinned.curve->scene, *curve->scene) &&
        pinned.curve->realizationsDone == curve->realizationsDone &&
        pinned.curve->isComplete == curve->isComplete)
      return 0;
  const auto isTaken = [this](int index) {
    return std::ranges::any_of(pinned_,
                               [&](const PinnedCurve& p) { return p.colourIndex == index; });
  };
  int index = 0;
  while (isTaken(index)) ++index;
  pinned_.push_back({++lastId_, index, std::move(curve)});
  fitRanges(false);
  return lastId_;
}

void FrictionChartModel::unpin(int id) {
  std::erase_if(pinned_, [id](const PinnedCurve& pinned) { return pinned.id == id; });
  fitRanges(true);
}

void FrictionChartModel::unpinAll() {
  pinned_.clear();
  fitRanges(true);
}

Message FrictionChartModel::englishName(const PinnedCurve& pinned, const Scene& present) const {
  const Message name = describeDifferences(*pinned.curve->scene, present);
  return listed({name.empty() ? Message("same parameters") : name, progressText(*pinned.curve)});
}

QString FrictionChartModel::pinnedName(const PinnedCurve& pinned) const {
  return readingText(englishName(pinned, present()));
}

void FrictionChartModel::showDifference(std::optional<CurveDifference> difference) {
  difference_ = std::move(difference);
}

void FrictionChartModel::showComparisons(const Scene& scene, CurveSet comparisons) {
  compared_ = scene;
  comparisons_ = std::move(comparisons);
  fitRanges(false);
}

bool FrictionChartModel::isDifferenceStale() const {
  return difference_ && (isStale() || !haveSameCurve(*difference_->scene, present()));
}

/// Returns the present curve and the pinned ones without their names, which take long to find.
CurveSet FrictionChartModel::unnamedCurves() const {
  CurveSet set = view();
  if (!curve_) return set;
  for (const PinnedCurve& pinned : pinned_)
    if (isOnThisAxis(*pinned.curve->scene))
      set.pinned.push_back(
          {{}, *pinned.curve->scene, pinned.curve->points, pinned.colourIndex, pinned.id});
  // A curve over the previous key cannot be drawn over the new axis.
  if (!hasCurve()) return set;
  set.present = {{}, *curve_->scene, curve_->points};
  addComparisons(set);
  return set;
}

/// Returns the curves with the names of the pinned ones: their differences from a scene.
CurveSet FrictionChartModel::curvesBeside(const Scene& present) const {
  CurveSet set = unnamedCurves();
  for (NamedCurve& curve : set.pinned)
    curve.name = englishName(*std::ranges::find(pinned_, curve.id, &PinnedCurve::id), present);
  return set;
}

bool FrictionChartModel::areComparisonsStale() const {
  return compared_ && curve_ && !haveSameCurve(*compared_, *curve_->scene);
}

void FrictionChartModel::addComparisons(CurveSet& set) const {
  const Comparisons& named = set.present.scene.comparison;
  // Names of tables are relative to the folder of their scene.
  if (!compared_ || !isOnThisAxis(*compared_) || compared_->comparison.data != named.data ||
      compared_->folder != set.present.scene.folder)
    return;
  set.theories = comparisons_.theories;
  std::erase_if(set.theories, [&](const TheoryCurve& theory) {
    return std::ranges::find(named.theory, theory.theory) == named.theory.end();
  });
  set.measured = comparisons_.measured;
  set.isReduced = comparisons_.isReduced;
  set.notes = comparisons_.notes;
  if (!areComparisonsStale()) return;
  try {
    placeMeasured(set);
  } catch (const InputError&) {  // no shift at a measured temperature: the work will report it
    set.measured.clear();
    set.isReduced = false;
  }
}

DiagramSheet FrictionChartModel::sheet() const {
  CurveSet set = curves();
  if (curve_ && set.isOfVelocity() && set.y == CurveQuantity::Mu) set.difference = difference_;
  DiagramSheet sheet = curveSheet(set);
  Diagram& diagram = sheet.diagrams.front();
  const bool isUsual = set.isOfVelocity() && diagram.x.scale == AxisScale::Logarithmic &&
                       diagram.y.scale == AxisScale::Logarithmic;
  setRange(diagram.x, xRange_.isEmpty() && isUsual ? kEmptyVelocities : xRange_);
  setRange(diagram.y,
           yRange_.isEmpty() && isUsual && isCoefficient(set.y) ? kEmptyCoefficients : yRange_);
  if (reach_ && diagram.y.from < diagram.y.to) {
    if (reach_->from > 0 || diagram.y.scale == AxisScale::Linear)
      diagram.y.from = std::min(diagram.y.from, reach_->from);
    diagram.y.to = std::max(diagram.y.to, reach_->to);
  }
  if (!curve_) diagram.series.clear();
  if (isStale()) {
    diagram.blank = {};
    for (DiagramSeries& series : diagram.series)
      series.isFaded = series.id <= kPresentCurve && series.id > kMeasuredCurves;
    for (auto* spans : {&diagram.spans, &diagram.shades})
      for (DiagramSpan& span : *spans) span.isFaded = true;
  }
  if (areComparisonsStale()) {
    for (DiagramSeries& series : diagram.series)
      if (series.id <= kTheoryCurves && series.id > kMeasuredCurves) series.isFaded = true;
    if (sheet.diagrams.size() > (set.difference ? 2U : 1U))
      for (DiagramSeries& series : sheet.diagrams[1].series) series.isFaded = !series.isTheory;
  }
  if (set.difference)
    for (DiagramSeries& series : sheet.diagrams.back().series) {
      series.isFaded = isDifferenceStale();
      if (difference_->done < difference_->total && !series.name.empty())
        series.name =
            listed({series.name, message("{} of {} lines", difference_->done, difference_->total)});
    }
  diagram.marker = marker();
  sheet.status = status();
  sheet.isGrowing = curve_ && !isStale() && !curve_->isComplete;
  if (concealed_) {
    sheet = withoutCurve(std::move(sheet), concealed_->from, concealed_->to);
    sheet.status = "the lesson hides the curve";
  }
  return sheet;
}

double FrictionChartModel::progress() const {
  constexpr double kMaxProgress = 0.999;
  if (!curve_ || isStale()) return 0;
  if (curve_->isComplete) return 1;
  if (curve_->realizationsTotal <= 0) return 0;
  return std::min(kMaxProgress, static_cast<double>(curve_->realizationsDone) /
                                    static_cast<double>(curve_->realizationsTotal));
}

std::optional<DiagramMarker> FrictionChartModel::marker() const {
  std::optional<DiagramMarker> marker =
      axes_ == CurveAxes::Physical ? marker_ : dimensionlessMarker_;
  if (!marker || markedKey_ != sweptKey_) return std::nullopt;
  marker->isFaded = isMarkFaded_;
  // The state itself stays: its friction is read above the contact, and a guess begins there.
  if (concealed_) marker->trace.clear();
  if (isMarkFaded_)
    marker->name = "before the change";
  else if (isMarkSettled_ && !marker->name.empty())
    marker->name = "this line, settled";
  else if (!marker->isFixed && curve_ && isOneLine(*curve_))
    marker->name = "now";
  return marker;
}

QString FrictionChartModel::describe(int id, int row) const {
  CurveSet set = curves();
  set.difference = difference_;
  if (areComparisonsStale())
    for (MeasuredCurve& measured : set.measured) measured.computed.clear();
  return pointText(set, id, row);
}

std::optional<double> FrictionChartModel::sweptValue(int id, int row) const {
  const CurveSet set = unnamedCurves();
  const NamedCurve* curve = findCurve(set, id);
  if (!curve || static_cast<std::size_t>(row) >= curve->points.size()) return std::nullopt;
  const CurvePoint& point = curve->points[static_cast<std::size_t>(row)];
  return set.isOfVelocity() ? point.velocity : point.swept;
}

std::optional<double> FrictionChartModel::sweptAt(double x) const {
  const double value = x / (axes_ == CurveAxes::Physical ? 1 : markerFactor_);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<CurveSet> FrictionChartModel::shown(const std::optional<VisibleRange>& zoom) const {
  if (!hasCurve()) return std::nullopt;
  CurveSet set = curvesBeside(*curve_->scene);
  if (areComparisonsStale()) clearComputedComparisons(set);
  if (difference_ && haveSameCurve(*difference_->scene, *curve_->scene))
    set.difference = difference_;
  if (zoom) {
    set.xFrom = axisValue(set.scaleOfX(), zoom->x.from);
    set.xTo = axisValue(set.scaleOfX(), zoom->x.to);
    set.yFrom = axisValue(set.scaleOfY(), zoom->y.from);
    set.yTo = axisValue(set.scaleOfY(), zoom->y.to);
  }
  return set;
}

Message FrictionChartModel::status() const {
  if (!curve_) return "no curve yet";
  if (isStale()) return "curve of the scene before";
  if (!mayHaveManyLines(curve_->scene->surface)) return {};
  std::int64_t done = curve_->realizationsDone, total = curve_->realizationsTotal;
  if (!curve_->scene->sweep.isOfVelocity()) {
    if (!curve_->isComplete) return finishedPart(*curve_);
    if (!curve_->points.empty()) done = total = curve_->points.front().realizations;
  }
  if (total == 1) return {};
  return message("{} of {} lines", done, total);
}

void FrictionChartModel::fitRanges(bool newCurve) {
  const CurveSet set = unnamedCurves();
  auto [along, up] = curveExtents(set);
  const auto addAlong = [&](double value) { along.add(axisPosition(set.scaleOfX(), value)); };
  if (expected_ && axes_ == CurveAxes::Physical) {
    const ParameterRange axis = sweepRange(*expected_);
    addAlong(axis.from);
    addAlong(axis.to);
  }
  const std::optional<DiagramMarker> shown = marker();
  const double height = shown ? axisPosition(set.scaleOfY(), shown->y) : kNotApplicable;
  if (shown && shown->isFixed) {
    // A motion often comes to rest: the axes then grow with it, but do not shrink.
    if (set.isOfVelocity()) addAlong(fastest_ * (axes_ == CurveAxes::Physical ? 1 : markerFactor_));
    if (up.isEmpty() || std::isgreater(height, up.most)) up.add(height);
  } else if (shown && marker_ && (expected_ || curve_)) {
    addAlong(shown->x);
    up.add(height);
  }
  xRange_ = knownRange(rangeAround(along, set.scaleOfX()), xRange_);
  if (set.scaleOfY() == AxisScale::Linear) {
    const AxisRange needed = rangeAround(up, AxisScale::Linear);
    yRange_ = newCurve ? knownRange(needed, yRange_) : grownRange(yRange_, needed);
    return;
  }
  const AxisRange needed = rangeAround(up, AxisScale::Logarithmic, kMarginFactor);
  yRange_ = steadyRange(yRange_, neededYRange(needed), newCurve);
}

/// Before there is a curve, the axis shows some decades of friction around the marker.
AxisRange FrictionChartModel::neededYRange(const AxisRange& data) const {
  if (curve_ || axes_ == CurveAxes::Dimensionless || quantity_ != CurveQuantity::Mu) return data;
  return steadyRange(kEmptyCoefficients, data, false);
}

}  // namespace asperity
