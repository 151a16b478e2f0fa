#include "core/base/linear_algebra.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A matrix whose third column is the sum of the others.
MatrixXd dependentColumns() {
  return MatrixXd{{1, 2, 3}, {0, 1, 1}, {4, -1, 3}, {2, 2, 4}};
}

TEST(LinearAlgebra, LeastSquaresLeaveWhatIsNormalToEveryColumn) {
  const MatrixXd matrix{{1, 0}, {1, 1}, {1, 2}, {1, 4}};
  const VectorXd right{{1, -2, 3, 0}};
  const LeastSquares solver(matrix);
  EXPECT_EQ(solver.rank(), 2);
  const VectorXd left = right - matrix * solver.solve(right);
  EXPECT_GT(left.norm(), 1);
  EXPECT_LT((matrix.transpose() * left).norm(), 1e-12);
  const MatrixXd both = solver.solveColumns(MatrixXd{{1, 1}, {-2, 2}, {3, 3}, {0, 5}});
  EXPECT_LT((both.col(0) - solver.solve(right)).norm(), 1e-14);
  EXPECT_LT((both.col(1) - VectorXd{{1, 1}}).norm(), 1e-12);
}

TEST(LinearAlgebra, ADependentColumnDoesNotCountForRankAndBasis) {
  const LeastSquares solver(dependentColumns());
  EXPECT_EQ(solver.rank(), 2);
  const MatrixXd basis = solver.basis();
  ASSERT_EQ(basis.cols(), 2);
  EXPECT_LT((basis.transpose() * basis - MatrixXd::Identity(2, 2)).norm(), 1e-14);
  EXPECT_LT((dependentColumns() - basis * basis.transpose() * dependentColumns()).norm(), 1e-13);
}

TEST(LinearAlgebra, TheSolutionOfLeastNormHasNoPartThatTheMatrixIgnores) {
  const VectorXd right{{1, 0, 2, 3}};
  const VectorXd solution = leastNormSolution(dependentColumns(), right);
  const VectorXd ignored{{1, 1, -1}};  // the matrix times this is 0
  EXPECT_NEAR(solution.dot(ignored), 0, 1e-13);
  EXPECT_LT((solution - pseudoInverse(dependentColumns()) * right).norm(), 1e-13);
}

TEST(LinearAlgebra, ThePseudoInverseFulfilsTheEquationsOfPenrose) {
  const MatrixXd m = dependentColumns(), inverse = pseudoInverse(m);
  EXPECT_LT((m * inverse * m - m).norm(), 1e-12);
  EXPECT_LT((inverse * m * inverse - inverse).norm(), 1e-13);
  EXPECT_LT((m * inverse - (m * inverse).transpose()).norm(), 1e-13);
  EXPECT_LT((inverse * m - (inverse * m).transpose()).norm(), 1e-13);
}

TEST(LinearAlgebra, TheNormalInverseAndTheTriangularFactorBelongTogether) {
  const MatrixXd matrix{{1, 0}, {1, 1}, {1, 2}, {1, 4}};
  const MatrixXd factor = triangularFactor(matrix);
  ASSERT_EQ(factor.rows(), 2);
  EXPECT_EQ(factor(1, 0), 0);
  EXPECT_LT((factor.transpose() * factor - matrix.transpose() * matrix).norm(), 1e-12);
  EXPECT_LT((normalInverse(matrix) * factor.transpose() * factor - MatrixXd::Identity(2, 2)).norm(),
            1e-13);
}

TEST(LinearAlgebra, PrincipalAxesTurnAMatrixIntoItsEigenvalues) {
  const MatrixXd symmetric{{2, 1, 0}, {1, 3, -1}, {0, -1, 5}};
  const PrincipalAxes found = principalAxes(symmetric);
  EXPECT_LT(found.values[0], found.values[1]);
  EXPECT_LT(found.values[1], found.values[2]);
  EXPECT_LT((found.axes.transpose() * symmetric * found.axes - MatrixXd(found.values.asDiagonal()))
                .norm(),
            1e-13);
}

}  // namespace
}  // namespace asperity
