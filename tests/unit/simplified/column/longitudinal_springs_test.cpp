// Requirements on the springs between neighbouring columns.
#include "simplified/column/longitudinal_springs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/unit/simplified/column/deposits.hpp"

namespace adit::simplified::column::test::longitudinal_springs_test {
namespace {

struct Soil {
  double modulus, damping;
};

Soil soil_at(const Deposit& deposit, double depth) {
  double bottom = 0;
  for (const Layer& layer : deposit.layers)
    if (depth < (bottom += layer.thickness)) return {layer.modulus_ratio * layer.modulus(), layer.damping};
  return {deposit.rock ? deposit.rock->modulus_ratio * deposit.rock->modulus() : 1e300, 0};
}

Eigen::VectorXd coordinates(const ModalColumn& column, double depth) {
  const auto psi = shapes_at(column, depth);
  Eigen::VectorXd result(psi.size() + 1);
  result << 1, Eigen::VectorXd::Map(psi.data(), static_cast<Eigen::Index>(psi.size()));
  return result;
}

struct Both {
  Eigen::MatrixXd stiffness, loss;
};

// int k (psi_a, -psi_b)(psi_a, -psi_b)^T dz by the midpoint rule.
Both by_quadrature(const ModalColumn& a, const ModalColumn& b, double distance) {
  const double depth = std::max(a.deposit.thickness(), b.deposit.thickness());
  constexpr int kPoints = 40000;
  const auto size = static_cast<Eigen::Index>(a.modes.size() + b.modes.size() + 2);
  Both result{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size)};
  for (int i = 0; i < kPoints; ++i) {
    const double z = depth * (i + 0.5) / kPoints;
    const Soil sa = soil_at(a.deposit, z), sb = soil_at(b.deposit, z);
    const double k = 1 / (distance / 2 / sa.modulus + distance / 2 / sb.modulus);
    const double xi = (sa.damping / sa.modulus + sb.damping / sb.modulus) / (1 / sa.modulus + 1 / sb.modulus);
    Eigen::VectorXd difference(size);
    difference << coordinates(a, z), -coordinates(b, z);
    const Eigen::MatrixXd product = k * depth / kPoints * difference * difference.transpose();
    result.stiffness += product;
    result.loss += 2 * xi * product;
  }
  return result;
}

Eigen::MatrixXd whole(const CouplingBlocks& blocks) {
  const auto na = blocks.aa.rows(), nb = blocks.bb.rows();
  Eigen::MatrixXd result(na + nb, na + nb);
  result << blocks.aa, blocks.ab, blocks.ab.transpose(), blocks.bb;
  return result;
}

class DifferentColumns : public ::testing::TestWithParam<bool> {
 protected:
  // Interfaces at different depths, rock at 40 m and at 27 m, and different modulus ratios.
  ModalColumn a = modal_column(with_ratio(three_layers(0.08), 1.7), 4);
  ModalColumn b = [] {
    Deposit deposit{{{12, 1700, 150, 0.03, 3.6}, {15, 1950, 300, 0.05, 2.9}}, {}};
    if (GetParam()) deposit.rock = Rock{kRock.density, kRock.wave_velocity, 2.7};
    return modal_column(deposit, 3);
  }();
};

// The coefficients are the integrals of the half-strips' springs in series, with rigid and with elastic rock.
TEST_P(DifferentColumns, StiffnessIsThatOfHalfStripsInSeries) {
  const Eigen::MatrixXd found = whole(longitudinal_springs(a, b, 22.5).stiffness);
  const Eigen::MatrixXd expected = by_quadrature(a, b, 22.5).stiffness;
  EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm());
}

// The dashpots dissipate the hysteretic loss of a coordinate that moves at its own frequency.
TEST_P(DifferentColumns, DashpotsLoseWhatHysteresisLoses) {
  const Eigen::MatrixXd found = whole(longitudinal_springs(a, b, 22.5).dashpots);
  Eigen::VectorXd frequencies(9);
  frequencies << a.modes[0].frequency, a.modes[0].frequency, a.modes[1].frequency, a.modes[2].frequency,
      a.modes[3].frequency, b.modes[0].frequency, b.modes[0].frequency, b.modes[1].frequency,
      b.modes[2].frequency;
  const Eigen::VectorXd roots = frequencies.cwiseSqrt();
  const Eigen::MatrixXd loss = roots.asDiagonal() * found * roots.asDiagonal();
  const Eigen::MatrixXd expected = by_quadrature(a, b, 22.5).loss;
  EXPECT_LT((loss - expected).norm(), 1e-5 * expected.norm());
}

// Springs and dashpots never feed energy.
TEST_P(DifferentColumns, AreNeverNegative) {
  const LongitudinalSprings springs = longitudinal_springs(a, b, 22.5);
  for (const CouplingBlocks* blocks : {&springs.stiffness, &springs.dashpots}) {
    const auto values = whole(*blocks).selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_GT(values.minCoeff(), -1e-12 * values.maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(Rock, DifferentColumns, ::testing::Values(false, true),
                         [](const auto& info) { return info.param ? "Elastic" : "Rigid"; });

// Equal columns that move alike feel nothing.
TEST(LongitudinalSprings, EqualMotionsAreFree) {
  const ModalColumn column = modal_column(three_layers(), 5);
  const LongitudinalSprings springs = longitudinal_springs(column, column, 10);
  EXPECT_LT((springs.stiffness.aa + springs.stiffness.ab).norm(), 1e-14 * springs.stiffness.aa.norm());
  EXPECT_LT((springs.dashpots.aa + springs.dashpots.ab).norm(), 1e-14 * springs.dashpots.aa.norm());
}

}  // namespace
}  // namespace adit::simplified::column::test::longitudinal_springs_test
