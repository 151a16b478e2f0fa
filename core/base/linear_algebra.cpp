#include "core/base/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

namespace asperity {

using Eigen::MatrixXd;
using Eigen::VectorXd;

LeastSquares::LeastSquares(const MatrixXd& matrix)
    : decomposition_(std::make_unique<Eigen::ColPivHouseholderQR<MatrixXd>>(matrix)) {}

LeastSquares::~LeastSquares() = default;

VectorXd LeastSquares::solve(const VectorXd& right) const {
  return decomposition_->solve(right);
}

MatrixXd LeastSquares::solveColumns(const MatrixXd& right) const {
  return decomposition_->solve(right);
}

Eigen::Index LeastSquares::rank() const {
  return decomposition_->rank();
}

MatrixXd LeastSquares::basis() const {
  return decomposition_->householderQ() * MatrixXd::Identity(decomposition_->rows(), rank());
}

VectorXd leastNormSolution(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.completeOrthogonalDecomposition().solve(right);
}

MatrixXd pseudoInverse(const MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

MatrixXd normalInverse(const MatrixXd& matrix) {
  return (matrix.transpose() * matrix)
      .ldlt()
      .solve(MatrixXd::Identity(matrix.cols(), matrix.cols()));
}

MatrixXd inverseOfPositive(const MatrixXd& symmetric) {
  const Eigen::LLT<MatrixXd> factor(symmetric);
  if (factor.info() != Eigen::Success) return {};
  return factor.solve(MatrixXd::Identity(symmetric.rows(), symmetric.cols()));
}

MatrixXd triangularFactor(const MatrixXd& matrix) {
  const Eigen::Index size = std::min(matrix.rows(), matrix.cols());
  return matrix.householderQr().matrixQR().topRows(size).triangularView<Eigen::Upper>();
}

PrincipalAxes principalAxes(const MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace asperity
