#include "core/friction/fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

/// A line that rises by less of the largest value, from its first x to its last, is flat.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

LineFit fitLine(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::VectorXd> abscissa(x.data(), count), ordinate(y.data(), count);
  Eigen::MatrixXd design(count, 2);
  design.col(0).setOnes();
  design.col(1) = abscissa;
  Eigen::Vector2d coefficients = design.colPivHouseholderQr().solve(ordinate);
  const double rise = coefficients[1] * (abscissa.maxCoeff() - abscissa.minCoeff());
  if (std::abs(rise) <= kRounding * ordinate.cwiseAbs().maxCoeff())
    coefficients = {ordinate.mean(), 0};
  const double squares = (ordinate - design * coefficients).squaredNorm();
  const double variance = count > 2 ? squares / static_cast<double>(count - 2)
                                    : std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix2d covariance = variance * (design.transpose() * design).inverse();
  return {coefficients[0], coefficients[1], std::sqrt(covariance(0, 0)),
          std::sqrt(covariance(1, 1)), std::sqrt(squares / static_cast<double>(count))};
}

LineFit fitPower(std::span<const double> x, std::span<const double> y) {
  std::vector<double> logX, logY;
  for (const double value : x) logX.push_back(std::log(value));
  for (const double value : y) logY.push_back(std::log(value));
  return fitLine(logX, logY);
}

}  // namespace asperity
