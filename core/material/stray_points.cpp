#include "core/material/stray_points.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/linear_algebra.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"

namespace asperity {
namespace {

constexpr Eigen::Index kMaxNeighbours = 6, kMinNeighbours = 4, kMaxUnknowns = 4;
constexpr double kClearScatter = 8;  // standard errors of the prediction
const double kClearFactor = std::log10(1.5);

/// One modulus of a sweep in decades.
struct Curve {
  std::vector<std::size_t> points;  // of the isotherm
  std::vector<double> x, y;
};

/// What the points beside one of a curve say about it, decades.
struct Prediction {
  double value = 0;
  double scatter = 0;    // of the points beside it
  double magnified = 1;  // the error of value and the point itself, over the scatter of one point
};

Prediction predicted(const Curve& curve, std::size_t at) {
  const auto count = static_cast<Eigen::Index>(curve.x.size());
  const Eigen::Index neighbours = std::min(kMaxNeighbours, count - 1);
  const Eigen::Index unknowns = std::min(kMaxUnknowns, neighbours - 2);
  const auto own = static_cast<Eigen::Index>(at);
  const Eigen::Index first =
      std::clamp<Eigen::Index>(own - neighbours / 2, 0, count - 1 - neighbours);
  const double scale = curve.x[static_cast<std::size_t>(first + neighbours)] -
                       curve.x[static_cast<std::size_t>(first)];
  Eigen::MatrixXd system(neighbours, unknowns);
  Eigen::VectorXd data(neighbours);
  for (Eigen::Index row = 0, i = first; i <= first + neighbours; ++i) {
    if (i == own) continue;
    const double u = (curve.x[static_cast<std::size_t>(i)] - curve.x[at]) / scale;
    for (Eigen::Index k = 0; k < unknowns; ++k)
      system(row, k) = std::pow(u, static_cast<double>(k));
    data[row++] = curve.y[static_cast<std::size_t>(i)];
  }
  // The polynomial has its origin at the point itself.
  const Eigen::MatrixXd inverse = pseudoInverse(system);
  const Eigen::VectorXd coefficients = inverse * data;
  const double squares = (data - system * coefficients).squaredNorm();
  return {coefficients[0], std::sqrt(squares / static_cast<double>(neighbours - unknowns)),
          std::sqrt(1 + inverse.row(0).squaredNorm())};
}

std::vector<Curve> curvesOf(std::span<const Isotherm> isotherms, double DynamicModulus::*modulus) {
  std::vector<Curve> curves;
  for (const Isotherm& isotherm : isotherms) {
    Curve& curve = curves.emplace_back();
    for (std::size_t i = 0; i < isotherm.points.size(); ++i) {
      curve.points.push_back(i);
      curve.x.push_back(std::log10(isotherm.points[i].frequency));
      curve.y.push_back(std::log10(isotherm.points[i].*modulus));
    }
  }
  return curves;
}

struct Found {
  StrayPoint stray;
  double deviation = 0;  // decades
};

/// A point of a curve that leaves it, and where it would be on it.
struct Deviant {
  std::size_t point;
  double suggested;  // decades
};

/// Returns the point of a curve that is the clearest one, if any is clear. The points beside it
/// seem to deviate as well, but less clearly, because their own neighbours scatter.
std::optional<Deviant> clearest(const Curve& curve, double usual) {
  std::optional<Deviant> found;
  double most = kClearScatter;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const Prediction prediction = predicted(curve, i);
    const double deviation = std::abs(curve.y[i] - prediction.value);
    const double scatter = std::max(prediction.scatter, usual) * prediction.magnified;
    if (!(deviation > kClearFactor && deviation > most * scatter)) continue;
    found = {i, prediction.value};
    if (!(scatter > 0)) break;
    most = deviation / scatter;
  }
  return found;
}

bool isLongEnough(const Curve& curve) {
  return std::ssize(curve.x) > static_cast<std::ptrdiff_t>(kMinNeighbours);
}

constexpr int kMaxOfOne = 10;  // strays of one curve

void removePoint(Curve& curve, std::size_t at) {
  const auto index = static_cast<std::ptrdiff_t>(at);
  curve.points.erase(curve.points.begin() + index);
  curve.x.erase(curve.x.begin() + index);
  curve.y.erase(curve.y.begin() + index);
}

/// Returns the median of the scatters. A stray point spoils all predictions that it takes part in,
/// which may be those of a whole short sweep, so what is clear by its own neighbours alone does not
/// take part.
double usualScatter(std::vector<Curve> curves) {
  std::vector<double> scatters;
  for (Curve& curve : curves) {
    for (int n = 0; n < kMaxOfOne && isLongEnough(curve); ++n) {
      const auto deviant = clearest(curve, 0);
      if (!deviant) break;
      removePoint(curve, deviant->point);
    }
    for (std::size_t i = 0; isLongEnough(curve) && i < curve.x.size(); ++i)
      scatters.push_back(predicted(curve, i).scatter);
  }
  return median(std::move(scatters));
}

void addStrays(std::span<const Isotherm> isotherms, bool isLoss, std::vector<Found>& found) {
  std::vector<Curve> curves =
      curvesOf(isotherms, isLoss ? &DynamicModulus::loss : &DynamicModulus::storage);
  const double usual = usualScatter(curves);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    Curve& curve = curves[k];
    for (int n = 0; n < kMaxOfOne && isLongEnough(curve); ++n) {
      const auto deviant = clearest(curve, usual);
      if (!deviant) break;
      const auto [at, suggested] = *deviant;
      found.push_back({{k, curve.points[at], isLoss, std::pow(10, suggested)},
                       std::abs(curve.y[at] - suggested)});
      removePoint(curve, at);
    }
  }
}

}  // namespace

double StrayPoint::value(std::span<const Isotherm> isotherms) const {
  const DynamicModulus& modulus = isotherms[isotherm].points[point];
  return isLoss ? modulus.loss : modulus.storage;
}

std::vector<StrayPoint> strayPoints(std::span<const Isotherm> isotherms) {
  std::vector<Found> found;
  addStrays(isotherms, false, found);
  addStrays(isotherms, true, found);
  std::ranges::stable_sort(found, std::ranges::greater{}, &Found::deviation);
  std::vector<StrayPoint> strays;
  for (const Found& one : found) strays.push_back(one.stray);
  return strays;
}

Isotherm withoutStrays(const Isotherm& isotherm, std::size_t index,
                       std::span<const StrayPoint> strays) {
  Isotherm rest = isotherm;
  rest.points.clear();
  for (std::size_t i = 0; i < isotherm.points.size(); ++i)
    if (std::ranges::none_of(strays, [&](const StrayPoint& stray) {
          return stray.isotherm == index && stray.point == i;
        }))
      rest.points.push_back(isotherm.points[i]);
  return rest;
}

Message describe(const StrayPoint& stray, std::span<const Isotherm> isotherms) {
  const Isotherm& isotherm = isotherms[stray.isotherm];
  return message("{} at {} and {} is {}, where the points beside it suggest {}",
                 stray.isLoss ? "G\u2033" : "G\u2032", celsius(isotherm.temperature),
                 printed(isotherm.points[stray.point].frequency, "Hz"),
                 printed(stray.value(isotherms), "Pa"), printed(stray.suggested, "Pa"));
}

}  // namespace asperity
