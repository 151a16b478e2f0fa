#include "core/accuracy/row_errors.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/accuracy/pilot.h"
#include "core/base/jobs.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/friction/realizations.h"

namespace asperity {
namespace {

/// The rows of a topography as its coarsest lines.
struct RowsAsLines {
  Scene scene;
  LineSource source;
  LoadCase sweep;

  RowsAsLines(const Scene& given, const std::vector<double>& velocities)
      : scene(withEveryRow(given)), source(scene, 1), sweep{given.load, velocities} {}

  static Scene withEveryRow(Scene scene) {
    scene.accuracy = {Scheme::Cubic, 1, 0};
    scene.ensemble.realizations = 0;
    return scene;
  }

  /// Slides `count` rows from the first; as slideRealizations.
  bool slide(std::int64_t first, std::int64_t count, int threads, const std::stop_token& stop,
             const TakeRealization& take) const {
    const RealizationPart part{scene, {&sweep, 1}};
    return slideRealizations({source, {&part, 1}, first}, count, threads, stop, take);
  }
};

}  // namespace

std::vector<MeanError> errorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                    int threads, const std::stop_token& stop) {
  const RowsAsLines rows(scene, velocities);
  std::vector<LineMean> means(velocities.size(), LineMean(rows.source.rows()));
  const auto take = [&](std::span<const SteadyResult> results) {
    for (std::size_t i = 0; i < results.size(); ++i) means[i].add(results[i].mu);
  };
  if (!rows.slide(0, rows.source.rows(), threads, stop, take)) return {};
  std::vector<MeanError> errors;
  for (const LineMean& mean : means) {
    errors.push_back(mean.error());
    errors.back().standardError /= std::abs(mean.mean());
  }
  return errors;
}

PredictedRowErrors predictErrorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                       const std::stop_token& stop) {
  constexpr std::int64_t kRows = 32;
  const RowsAsLines rows(scene, velocities);
  const double start = threadSeconds();
  const std::int64_t count = std::min(kRows, rows.source.rows());
  std::vector<std::vector<double>> mu(velocities.size());
  const auto take = [&](std::span<const SteadyResult> results) {
    for (std::size_t i = 0; i < results.size(); ++i) mu[i].push_back(results[i].mu);
  };
  for (const std::int64_t row : sampledLines(rows.source, count))
    if (!rows.slide(row, 1, 1, stop, take)) throw StopRequested{};
  const auto all = static_cast<double>(rows.source.rows());
  PredictedRowErrors predicted;
  for (const std::vector<double>& each : mu)
    predicted.standardErrors.push_back(std::sqrt(varianceOfMean(each, rows.source, all)) /
                                       std::abs(mean(each)));
  predicted.seconds = (threadSeconds() - start) * all / static_cast<double>(count);
  return predicted;
}

}  // namespace asperity
