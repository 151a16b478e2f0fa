// The Fisher information of measured points about parameters: its inverse, the directions that the
// points leave open, and what a step along the others promises. A part of core/fit/fit.cpp. Pure.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace asperity {

/// The Fisher information, a symmetric matrix, by its principal
/// directions.
class FisherInformation {
 public:
  explicit FisherInformation(const Eigen::MatrixXd& matrix) : directions_(matrix) {}

  /// Returns the inverse; directions without information get a very large value instead of an
  /// infinite one.
  Eigen::MatrixXd inverse() const {
    constexpr double kNothing = 1e-15;
    const Eigen::VectorXd known = directions_.eigenvalues().cwiseMax(least(kNothing));
    return directions_.eigenvectors() * known.cwiseInverse().asDiagonal() *
           directions_.eigenvectors().transpose();
  }

  /// Returns the covariance of the directions without information, such as force and modulus
  /// together, of which only the ratio matters. Along them the response to the points' errors is 0,
  /// but the values may be anything.
  Eigen::MatrixXd openCovariance() const {
    const Eigen::MatrixXd& axes = directions_.eigenvectors();
    Eigen::MatrixXd open = Eigen::MatrixXd::Zero(axes.rows(), axes.cols());
    for (Eigen::Index k = 0; k < axes.cols(); ++k)
      if (directions_.eigenvalues()[k] < least(kOpen))
        open += axes.col(k) * axes.col(k).transpose() / least(kOpen);
    return open;
  }

  /// Returns by how much a step to the minimum of the parabola lowers the sum of squares, whose
  /// gradient is twice the given one. Directions without information lower nothing.
  double possibleDecrease(const Eigen::VectorXd& gradient) const {
    double decrease = 0;
    for (Eigen::Index k = 0; k < gradient.size(); ++k) {
      const double information = directions_.eigenvalues()[k];
      if (information < least(kOpen)) continue;
      const double part = directions_.eigenvectors().col(k).dot(gradient);
      decrease += part * part / information;
    }
    return decrease;
  }

 private:
  /// Directions with less than this share of the best information are open.
  static constexpr double kOpen = 1e-10;

  /// Returns the information below which a direction counts as unknown: this share of the best
  /// known one, and never 0.
  double least(double share) const {
    return std::max(share * directions_.eigenvalues().maxCoeff(),
                    std::numeric_limits<double>::min() * 1e10);
  }

  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> directions_;
};

}  // namespace asperity
