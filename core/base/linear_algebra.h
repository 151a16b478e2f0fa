#pragma once

#include <Eigen/Core>
#include <memory>

namespace asperity {

// Decompositions of small dense matrices by Eigen. Its templates take seconds to compile, so they
// are compiled here alone.

/// Least squares by a QR decomposition with column pivoting (Golub and Van Loan, Matrix
/// Computations, section 5.4).
class LeastSquares {
 public:
  explicit LeastSquares(const Eigen::MatrixXd& matrix);
  ~LeastSquares();

  /// Returns an x that minimizes |matrix x - right|. Unknowns that the matrix does not determine
  /// are 0.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// The same for each column of `right`.
  Eigen::MatrixXd solveColumns(const Eigen::MatrixXd& right) const;

  /// Returns the number of columns that are linearly independent.
  Eigen::Index rank() const;

  /// Returns `rank()` orthonormal columns that span the same space as those of the matrix.
  Eigen::MatrixXd basis() const;

 private:
  std::unique_ptr<const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>> decomposition_;
};

/// Returns the x that minimizes |matrix x - right|; of several, the one with the least norm.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Returns the pseudo-inverse of Moore and Penrose.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& matrix);

/// Returns (M^T M)^-1, the covariance of fitted unknowns where every value has the variance 1.
Eigen::MatrixXd normalInverse(const Eigen::MatrixXd& matrix);

/// Returns the inverse of a symmetric positive definite matrix, by its Cholesky factor; empty
/// where it is not positive definite.
Eigen::MatrixXd inverseOfPositive(const Eigen::MatrixXd& symmetric);

/// Returns the upper triangular factor R of M = Q R, with as many rows as M has rows or columns,
/// whichever are fewer.
Eigen::MatrixXd triangularFactor(const Eigen::MatrixXd& matrix);

/// The eigenvalues of a symmetric matrix, from the smallest to the largest, and its orthonormal
/// eigenvectors as columns.
struct PrincipalAxes {
  Eigen::VectorXd values;
  Eigen::MatrixXd axes;
};

PrincipalAxes principalAxes(const Eigen::MatrixXd& symmetric);

}  // namespace asperity
