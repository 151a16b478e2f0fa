#include "ui/chart/friction_chart_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/chart/curve_set.h"
#include "core/chart/curve_words.h"
#include "core/fit/derivatives.h"
#include "core/run/transient_diagram.h"
#include "core/scene/motion.h"
#include "core/scene/sweep.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr AxisRange kEmptyVelocities{-5, 3};  // shown before anything is known
constexpr AxisRange kEmptyCoefficients{-6, -2};

constexpr double kMarginFactor = 1.15;
// The binary value of 1e-5 may lie a little below the decade; this must not add another decade.
constexpr double kSlack = 1e-9;

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0;
}

bool hasKnownPoint(const CurveUpdate& update) {
  return std::any_of(update.points.begin(), update.points.end(), isKnown);
}

bool isOneLine(const CurveUpdate& curve) {
  return curve.realizationsTotal <= 1;
}

/// The smallest and largest number that an axis of this scale can show.
struct Extent {
  AxisScale scale = AxisScale::Logarithmic;
  double low = kNotApplicable, high = kNotApplicable;

  bool isEmpty() const { return std::isnan(high); }
  void add(double value) {
    if (!std::isfinite(value) || (scale == AxisScale::Logarithmic && value <= 0)) return;
    low = isEmpty() ? value : std::min(low, value);
    high = isEmpty() ? value : std::max(high, value);
  }
  /// Returns whole decades around the numbers, or the numbers with a margin; `marginFactor` is the
  /// factor between them and the ends of a logarithmic axis.
  AxisRange range(double marginFactor = 1) const {
    if (isEmpty()) return {};
    if (scale == AxisScale::Logarithmic)
      return decadesAround(low / marginFactor, high * marginFactor);
    constexpr double kMargin = 0.04;
    const double margin = high > low ? kMargin * (high - low) : std::max(std::abs(high), 1e-12) / 2;
    return {low >= 0 && low < (high - low) / 2 ? 0 : low - margin, high + margin};
  }
};

void addCurve(const CurveUpdate& curve, const CurveSet& view, Extent& along, Extent& up) {
  for (const CurvePoint& point : curve.points) {
    along.add(abscissa(point, *curve.scene, view));
    if (!isKnown(point)) continue;
    const double value = ordinate(point, view);
    up.add(value);
    const double error = point.muStandardError * perFriction(view.quantity(), point);
    if (isCoefficient(view.y) && point.mu > 0) up.add(value + error);
  }
}

/// Sets the range; an axis for which none is known finds its own.
void setRange(DiagramAxis& axis, const AxisRange& range) {
  if (range.isEmpty()) return;
  const bool isLinear = axis.scale == AxisScale::Linear;
  axis.from = isLinear ? range.from : std::pow(10, range.from);
  axis.to = isLinear ? range.to : std::pow(10, range.to);
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

/// Returns the power of ten of a number's first digit.
int decadeOf(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Returns "0.00116 ± 0.00012" or "(2.637 ± 0.012)×10⁻⁷": two digits of the error, and the value to
/// the same place, with at least three digits.
QString valueWithError(double value, double error) {
  const QString alone = readingLabel(value);
  if (!(std::isfinite(value) && std::isfinite(error) && error > 0 && value != 0)) return alone;
  constexpr int kMaxDecimals = 15;
  const bool isPower = alone.contains(QStringLiteral("10⁻")) || alone.contains(u'×');
  const int power = isPower ? decadeOf(value) : 0;
  const int last = std::min(decadeOf(error) - 1, decadeOf(value) - 2) - power;
  const double unit = std::pow(10, power);
  const auto text = [&](double number) {
    const QString digits = QString::number(number / unit, 'f', std::clamp(-last, 0, kMaxDecimals));
    return inLanguage(QString(digits).replace('-', u'−'));
  };
  const QString both = text(value) + QStringLiteral(" ± ") + text(error);
  return isPower ? '(' + both + QStringLiteral(")×") + QString::fromStdString(powerOfTen(power))
                 : both;
}

QString withError(const QString& name, double value, double error) {
  return name + " = " + valueWithError(value, error);
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

QString velocityText(double velocity) {
  return QStringLiteral("v = ") + QString::fromStdString(quantity(velocity, "m/s"));
}

QString signedPercent(double part) {
  const QString text = readingLabel(std::abs(100 * part));
  return (part < 0 ? "−" : "+") + text + " %";
}

}  // namespace

bool haveSameCurve(const Scene& a, const Scene& b) {
  return canonicalCurveScene(a) == canonicalCurveScene(b);
}

AxisRange decadesAround(double low, double high) {
  AxisRange range{std::floor(std::log10(low) + kSlack), std::ceil(std::log10(high) - kSlack)};
  if (range.isEmpty()) range.to = range.from + 1;
  return range;
}

AxisRange steadyRange(const AxisRange& shown, const AxisRange& needed, bool mayShrink) {
  if (needed.isEmpty()) return shown;
  if (shown.isEmpty()) return needed;
  AxisRange next{std::min(shown.from, needed.from), std::max(shown.to, needed.to)};
  if (!mayShrink) return next;
  if (needed.from - next.from >= 2) next.from = needed.from;
  if (next.to - needed.to >= 2) next.to = needed.to;
  return next;
}

void FrictionChartModel::expect(const Scene& scene) {
  expected_ = scene;
  const bool isOtherAxis = scene.sweep.key != sweptKey_;
  if (isOtherAxis) {
    sweptKey_ = scene.sweep.key;
    if (!scene.sweep.isOfVelocity()) axes_ = CurveAxes::Physical;
    velocities_ = coefficients_ = {};
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
    coefficients_ = {};
    resetsAxesWithMark_ = true;
  }
  fitRanges(newCurve);
  return true;
}

bool FrictionChartModel::mark(const Frame& frame) {
  const std::pair before{velocities_, coefficients_};
  marker_ = frameMarker(frame, CurveAxes::Physical, quantity_);
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
  if (isItsMarker && std::exchange(resetsAxesWithMark_, false)) coefficients_ = {};
  fitRanges(isItsMarker);
  return before == std::pair{velocities_, coefficients_};
}

void FrictionChartModel::fitVerticalAxis() {
  reach_.reset();
  coefficients_ = {};
  fitRanges(true);
}

void FrictionChartModel::setAxes(CurveAxes axes) {
  if (axes == axes_) return;
  axes_ = axes;
  reach_.reset();
  velocities_ = coefficients_ = {};
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
  return curve_ ? pin(curve_) : 0;
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
  return translatedText(englishName(pinned, present()));
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

/// Returns the present curve and the pinned ones, named by their differences from a scene.
CurveSet FrictionChartModel::curves(const Scene& present) const {
  CurveSet set = view();
  if (!curve_) return set;
  // A curve over the previous key cannot be drawn over the new axis.
  if (isOnThisAxis(*curve_->scene)) set.present = {{}, *curve_->scene, curve_->points};
  for (const PinnedCurve& pinned : pinned_)
    if (isOnThisAxis(*pinned.curve->scene))
      set.pinned.push_back({englishName(pinned, present), *pinned.curve->scene,
                            pinned.curve->points, pinned.colourIndex, pinned.id});
  if (isOnThisAxis(*curve_->scene)) addComparisons(set);
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
  } catch (const InputError&) {  // no shift at a measured temperature: the work will say so
    set.measured.clear();
    set.isReduced = false;
  }
}

DiagramSheet FrictionChartModel::sheet() const {
  CurveSet set = curves(curve_ ? present() : Scene{});
  if (curve_ && set.isOfVelocity() && set.y == CurveQuantity::Mu) set.difference = difference_;
  DiagramSheet sheet = curveSheet(set);
  Diagram& diagram = sheet.diagrams.front();
  const bool isUsual = set.isOfVelocity() && diagram.x.scale == AxisScale::Logarithmic &&
                       diagram.y.scale == AxisScale::Logarithmic;
  setRange(diagram.x, velocities_.isEmpty() && isUsual ? kEmptyVelocities : velocities_);
  setRange(diagram.y, coefficients_.isEmpty() && isUsual && isCoefficient(set.y)
                          ? kEmptyCoefficients
                          : coefficients_);
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
  if (concealed_) hideCurve(sheet);
  return sheet;
}

void FrictionChartModel::hideCurve(DiagramSheet& sheet) const {
  sheet.diagrams.resize(1);
  sheet.note = {};
  Diagram& diagram = sheet.diagrams.front();
  std::erase_if(diagram.series,
                [](const DiagramSeries& series) { return series.id <= kPresentCurve; });
  diagram.spans.clear();
  diagram.shades.clear();
  diagram.blank = {};
  diagram.y.from = concealed_->from;
  diagram.y.to = concealed_->to;
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
  else if (!marker->isFixed && curve_ && isOneLine(*curve_))
    marker->name = "now";
  return marker;
}

const CurveUpdate* FrictionChartModel::find(int id) const {
  if (id == kPresentCurve || id == kTotalCurve) return curve_.get();
  for (const PinnedCurve& pinned : pinned_)
    if (pinned.id == id) return pinned.curve.get();
  return nullptr;
}

QString FrictionChartModel::describe(int id, int row) const {
  const auto index = static_cast<std::size_t>(row);
  if (id == kDifferenceCurve)
    return difference_ && index < difference_->points.size() ? reading(difference_->points[index])
                                                             : QString();
  const auto table = static_cast<std::size_t>(kMeasuredCurves - id);
  if (id <= kMeasuredCurves) {
    const CurveSet set = curves(present());
    return table < set.measured.size() ? describeMeasured(set.measured[table], index) : QString();
  }
  const CurveUpdate* curve = find(id);
  if (!curve || index >= curve->points.size()) return {};
  const QString text = reading(curve->points[index], *curve->scene);
  if (id == kPresentCurve || id == kTotalCurve) return text;
  const auto pinned = std::ranges::find(pinned_, id, &PinnedCurve::id);
  return pinnedName(*pinned) + '\n' + text;
}

QString FrictionChartModel::describeMeasured(const MeasuredCurve& measured,
                                             std::size_t index) const {
  if (index >= measured.data.points.size()) return {};
  const MeasuredPoint& point = measured.data.points[index];
  const QString name = QString::fromStdString(measured.data.name);
  QStringList lines{point.label.empty() ? name : name + ", " + QString::fromStdString(point.label)};
  lines += velocityText(point.velocity);
  if (index < measured.abscissas.size() && present().sweep.isOfVelocity())
    lines += reducedReading(point.velocity, measured.abscissas[index], point.temperature);
  lines += withError(QStringLiteral("μ"), point.mu, point.muError);
  if (index < measured.computed.size() && !areComparisonsStale())
    lines += tr("computed: %1").arg(readingLabel(totalMu(measured.computed[index])));
  return lines.join('\n');
}

QStringList FrictionChartModel::reducedReading(double velocity, double reduced,
                                               double temperature) const {
  QStringList lines;
  if (axes_ == CurveAxes::Physical && reduced != velocity)
    lines +=
        QStringLiteral("a\u1D1B v = ") + QString::fromStdString(asperity::quantity(reduced, "m/s"));
  if (std::isfinite(temperature))
    lines +=
        QStringLiteral("T = ") + QString::fromStdString(asperity::quantity(temperature, "K", 4));
  return lines;
}

QString FrictionChartModel::reading(const CurvePoint& point, const Scene& scene) const {
  QStringList lines;
  if (!scene.sweep.isOfVelocity())
    lines += translatedText(describeParameter(scene.sweep.key, withSweptValue(scene, point.swept)));
  lines += velocityText(point.velocity);
  CurveSet set = view();
  if (curve_ && isOnThisAxis(*curve_->scene)) {
    set.present.scene = *curve_->scene;
    addComparisons(set);
  }
  if (set.hasReducedAxis())
    lines +=
        reducedReading(point.velocity, abscissa(point, scene, set), scene.elastomer.temperature);
  if (axes_ == CurveAxes::Physical && quantity_ != CurveQuantity::Mu) {
    const QuantityEntry& entry = quantityEntry(quantity_);
    lines +=
        translatedText(entry.title) + " = " +
        QString::fromStdString(asperity::quantity(quantityValue(quantity_, point), entry.unit));
  }
  lines += withError(QStringLiteral("μ"), point.mu, point.muStandardError);
  if (std::isfinite(point.muInterface) && quantity_ != CurveQuantity::MuTotal)
    lines += tr("with local friction: %1").arg(readingLabel(totalMu(point)));
  if (axes_ == CurveAxes::Dimensionless) {
    lines.prepend(QStringLiteral("v̄ = ") + readingLabel(point.dimensionlessVelocity));
    lines += withError(QStringLiteral("μ / ∇z"), point.normalizedMu,
                       point.muStandardError * point.normalizedMu / point.mu);
  }
  lines += tr("in contact %1 %").arg(readingLabel(100 * point.contactFraction));
  if (std::isfinite(point.muLaw)) lines += tr("Eq. (11): %1").arg(readingLabel(point.muLaw));
  return lines.join('\n');
}

QString FrictionChartModel::reading(const DifferencePoint& point) const {
  QString difference = tr("difference %1").arg(signedPercent(point.relative));
  if (std::isfinite(point.standardError))
    difference += " ± " + readingLabel(100 * point.standardError, 2) + " %";
  return velocityText(point.velocity) + '\n' + difference + '\n' +
         withError(QStringLiteral("μ"), point.mu, point.muStandardError) + ' ' +
         tr("with %1").arg(translatedText(settingName(difference_->setting)));
}

std::optional<double> FrictionChartModel::sweptValue(int id, int row) const {
  const CurveUpdate* curve = find(id);
  if (!curve || static_cast<std::size_t>(row) >= curve->points.size()) return std::nullopt;
  const CurvePoint& point = curve->points[static_cast<std::size_t>(row)];
  return curve->scene->sweep.isOfVelocity() ? point.velocity : point.swept;
}

std::optional<double> FrictionChartModel::sweptAt(double x) const {
  const double value = x / (axes_ == CurveAxes::Physical ? 1 : markerFactor_);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<CurveSet> FrictionChartModel::shown(const std::optional<VisibleRange>& zoom) const {
  if (!curve_ || !isOnThisAxis(*curve_->scene)) return std::nullopt;
  CurveSet set = curves(*curve_->scene);
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
  CurveSet set = view();
  // The axis is that of the curve: its temperature is that of the reduced velocity.
  if (curve_ && isOnThisAxis(*curve_->scene)) {
    set.present.scene = *curve_->scene;
    addComparisons(set);
  }
  Extent along{set.scaleOfX()}, up{set.scaleOfY()};
  if (expected_ && axes_ == CurveAxes::Physical) {
    const Sweep& sweep = expected_->sweep;
    along.add(sweep.isOfVelocity() ? sweep.velocityFrom : sweep.from);
    along.add(sweep.isOfVelocity() ? sweep.velocityTo : sweep.to);
  }
  if (curve_ && isOnThisAxis(*curve_->scene)) {
    addCurve(*curve_, set, along, up);
    const double friction = asperity::axesFactors(curve_->points, axes_).friction;
    if (set.y == CurveQuantity::Mu)
      for (const CurvePoint& point : curve_->points) up.add(point.muLaw * friction);
    if (showsTotal(set))
      for (const CurvePoint& point : curve_->points)
        if (isKnown(point)) up.add(totalMu(point) * perFriction(set.quantity(), point));
  }
  for (const PinnedCurve& pinned : pinned_)
    if (isOnThisAxis(*pinned.curve->scene)) addCurve(*pinned.curve, set, along, up);
  if (!set.measured.empty()) {
    const AxesFactors factors = asperity::axesFactors(curve_->points, axes_);
    for (const MeasuredCurve& measured : set.measured)
      for (std::size_t i = 0; i < measured.abscissas.size(); ++i) {
        along.add(measured.abscissas[i] * factors.velocity);
        up.add(measured.data.points[i].mu * measuredFactor(measured, i, set, factors));
      }
  }
  const bool isMarked = marker_ && (expected_ || curve_);
  if (const std::optional<DiagramMarker> shown = marker(); shown && shown->isFixed) {
    // A motion often comes to rest: the axes then grow with it, but do not shrink.
    if (set.isOfVelocity())
      along.add(fastest_ * (axes_ == CurveAxes::Physical ? 1 : markerFactor_));
    if (up.isEmpty() || std::isgreater(shown->y, up.high)) up.add(shown->y);
  } else if (shown && isMarked) {
    along.add(shown->x);
    up.add(shown->y);
  }
  if (const AxisRange needed = along.range(); !needed.isEmpty()) velocities_ = needed;
  if (up.scale == AxisScale::Linear) {
    const AxisRange needed = up.range();
    const bool isUnion = !newCurve && !coefficients_.isEmpty() && !needed.isEmpty();
    if (isUnion)
      coefficients_ = {std::min(coefficients_.from, needed.from),
                       std::max(coefficients_.to, needed.to)};
    else if (!needed.isEmpty())
      coefficients_ = needed;
    return;
  }
  coefficients_ = steadyRange(coefficients_, neededCoefficients(up.range(kMarginFactor)), newCurve);
}

/// Before there is a curve, the axis shows some decades of friction around the marker.
AxisRange FrictionChartModel::neededCoefficients(const AxisRange& data) const {
  if (curve_ || axes_ == CurveAxes::Dimensionless || quantity_ != CurveQuantity::Mu) return data;
  return steadyRange(kEmptyCoefficients, data, false);
}

}  // namespace asperity
