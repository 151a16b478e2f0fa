#include "core/friction/curve_difference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/friction/ensemble.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// The largest number of realizations of one setting before the other setting continues.
constexpr std::int64_t kLargestPart = 32;

/// One way to compute the curve, a few lines at a time.
class Side {
 public:
  Side(Scene scene, std::vector<double> velocities)
      : scene_(std::move(scene)),
        source_(scene_, curvePointsPerElement(scene_)),
        sweep_{scene_.load, std::move(velocities)},
        total_(source_.lines()) {}

  std::int64_t total() const { return total_; }
  std::int64_t orderedRows() const { return source_.orderedRows(); }
  std::int64_t done() const { return done_; }

  /// Appends mu of lines up to this number, line by line; returns false where stop was requested.
  bool slide(std::int64_t upTo, const DifferenceOptions& options,
             std::vector<std::vector<double>>& rows) {
    const std::int64_t count = std::min(upTo, total_) - done_;
    rows.clear();
    if (count <= 0) return true;
    const RealizationPart part{scene_, {&sweep_, 1}};
    const bool isWhole =
        slideRealizations({source_, {&part, 1}, done_}, count, options.threads, options.stop,
                          [&](std::span<const SteadyResult> results) {
                            std::vector<double>& row = rows.emplace_back();
                            for (const SteadyResult& result : results) row.push_back(result.mu);
                          });
    done_ += count;
    return isWhole;
  }

 private:
  Scene scene_;
  LineSource source_;
  LoadCase sweep_;
  std::int64_t total_, done_ = 0;
};

}  // namespace

void PairedMeans::addPair(double a, double b) {
  const double before = a_.count() > 0 ? a - a_.mean() : 0;
  a_.add(a);
  b_.add(b);
  products_ += before * (b - b_.mean());
  if (orderedRowsOfA_ > 0) rowsOfA_.push_back(a);
  if (orderedRowsOfB_ > 0) rowsOfB_.push_back(b);
}

/// Returns the standard error of mean_b - R mean_a over rows in order.
double PairedMeans::errorOfRows(double ratio) const {
  if (orderedRowsOfA_ != orderedRowsOfB_ || rowsOfA_.size() != rowsOfB_.size())
    return std::hypot(lineMeanError(rowsOfB_, orderedRowsOfB_).standardError,
                      ratio * lineMeanError(rowsOfA_, orderedRowsOfA_).standardError);
  std::vector<double> differences(rowsOfB_);
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= ratio * rowsOfA_[i];
  return lineMeanError(differences, orderedRowsOfA_).standardError;
}

/// With n pairs, N_a and N_b lines of each and ratio R, mean_b - R mean_a is a sum of independent
/// terms: one for each pair (b / N_b - R a / N_a), and one for each line that only one side has.
Estimate PairedMeans::ratio() const {
  Estimate ratio{meanB() / meanA(), kNotApplicable};
  const auto count = [](const RunningMean& mean) { return static_cast<double>(mean.count()); };
  const double n = count(a_), onlyA = count(onlyA_), onlyB = count(onlyB_);
  if (n < 2 || !std::isfinite(ratio.value)) return ratio;
  if (orderedRowsOfA_ > 0 && orderedRowsOfB_ > 0) {
    ratio.standardError = errorOfRows(ratio.value) / std::abs(meanA());
    return ratio;
  }
  const double wa = ratio.value / (n + onlyA), wb = 1 / (n + onlyB);
  const double covariance = products_ / (n - 1);
  const double ofPairs =
      wb * wb * b_.variance() - 2 * wa * wb * covariance + wa * wa * a_.variance();
  // Lines of one side only have the variance of all lines of that side.
  const double ofA = both(a_, onlyA_).variance(), ofB = both(b_, onlyB_).variance();
  const double variance =
      n * std::max(0.0, ofPairs) + onlyA * wa * wa * ofA + onlyB * wb * wb * ofB;
  ratio.standardError = std::sqrt(variance) / std::abs(meanA());
  return ratio;
}

Message settingName(const CurveSetting& setting) {
  const auto choices = std::get<ChoiceField>(findParameter("accuracy.scheme")->field).choices;
  const Message scheme(choices[static_cast<std::size_t>(setting.scheme)]);
  const Message lines =
      setting.realizations == 1 ? Message("1 line") : message("{} lines", setting.realizations);
  return setting.scheme == Scheme::Nodal
             ? listed({scheme, lines})
             : listed({message("{} x{}", scheme, setting.oversampling), lines});
}

Scene withSetting(Scene scene, const CurveSetting& setting) {
  scene.accuracy = {setting.scheme, setting.oversampling, 0};
  scene.ensemble.realizations = setting.realizations;
  return scene;
}

CurveDifference curveDifference(const Scene& scene, const CurveSetting& setting,
                                const DifferenceOptions& options) {
  requireSteadySliding(scene, "a comparison of curves");
  requireNoTarget(scene, "a comparison needs the same resolution at every velocity");
  const std::vector<double> velocities = sweepVelocities(scene.sweep);
  Side own(scene, velocities), other(withSetting(scene, setting), velocities);
  CurveDifference difference{
      std::make_shared<const Scene>(scene), setting, {}, 0, own.total() + other.total()};
  std::vector<PairedMeans> means(velocities.size(),
                                 PairedMeans(own.orderedRows(), other.orderedRows()));
  std::vector<std::vector<double>> a, b;
  const std::int64_t most = std::max(own.total(), other.total());
  for (std::int64_t part = 1, upTo = 1; difference.done < difference.total;
       part = std::min(2 * part, kLargestPart), upTo = std::min(upTo + part, most)) {
    if (!own.slide(upTo, options, a) || !other.slide(upTo, options, b)) break;
    for (std::size_t r = 0; r < std::max(a.size(), b.size()); ++r)
      for (std::size_t i = 0; i < means.size(); ++i) {
        if (r < a.size() && r < b.size())
          means[i].addPair(a[r][i], b[r][i]);
        else if (r < a.size())
          means[i].addOnlyA(a[r][i]);
        else
          means[i].addOnlyB(b[r][i]);
      }
    difference.done = own.done() + other.done();
    difference.points.clear();
    for (std::size_t i = 0; i < means.size(); ++i) {
      const Estimate ratio = means[i].ratio();
      difference.points.push_back({velocities[i], means[i].meanB(), means[i].standardErrorB(),
                                   ratio.value - 1, ratio.standardError});
    }
    if (options.progress) options.progress(difference);
  }
  return difference;
}

}  // namespace asperity
