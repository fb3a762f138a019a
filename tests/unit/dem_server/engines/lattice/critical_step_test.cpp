#include "dem_server/engines/lattice/critical_step.hpp"

#include <gtest/gtest.h>

#include "dem_server/packing/meeting_place.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::critical_step_test {
namespace {

// 2 / omega of the assembled lattice's highest mode.
double exact_step(const ContactBond& law, const Assembly& a) {
  const Eigen::MatrixXd mass = test::mass_diagonal(a.particles).asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(test::stiffness_matrix(law, a)), mass, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

// Inside a large lattice the bound is the larger of the modes 12 kn / m and 36 ks / m.
TEST(CriticalStep, InteriorBondGovernsLargeLattices) {
  const double mass = 5.0;
  const Assembly a = test::assemble(test::rows_of(9, 9), mass);
  EXPECT_DOUBLE_EQ(critical_step(a, {7.0, 1.0}), 2 / std::sqrt(12 * 7.0 / mass));
  EXPECT_DOUBLE_EQ(critical_step(a, {7.0, 6.0}), 2 / std::sqrt(36 * 6.0 / mass));
}

// A lone bond: the bound is the exact frequency of two masses on a spring.
TEST(CriticalStep, LoneBondIsExact) {
  EXPECT_DOUBLE_EQ(critical_step(test::pair_of_particles(2.0), {7.0, 0.0}),
                   2 / std::sqrt(7.0 * (1 / 2.0 + 1 / 2.0)));
}

// Its place is told: that of the bond between the two lightest particles.
TEST(CriticalStep, IsToldWithItsPlace) {
  Assembly a = test::assemble(test::rows_of(5, 6), 2.0);
  const std::uint32_t k = a.bonds.runs.front().begin + 2;
  for (const std::uint32_t i : {a.bonds.first[k], a.bonds.second[k]}) a.particles.inverse_mass[i] *= 10;
  const auto [x, y] = meeting_place(a.particles, a.bonds.first[k], a.bonds.second[k]);
  const auto told = critical_element(a, {7.0, 1.0});
  EXPECT_DOUBLE_EQ(told.x, x);
  EXPECT_DOUBLE_EQ(told.y, y);
}

// The bound is never above the exact step of the assembled lattice, nor wastefully below it.
TEST(CriticalStep, StaysBelowTheExactStep) {
  for (const double shear : {0.0, 2.0, 7.0}) {
    const ContactBond law{{7.0, shear}, kUnbreakable, kUnbreakable};
    const Assembly a = test::assemble(test::rows_of(5, 6), 2.0);
    const double bound = critical_step(a, law.stiffness), exact = exact_step(law, a);
    EXPECT_LE(bound, exact);
    EXPECT_GT(bound, 0.6 * exact);
  }
}

// Weights of any kind, vanished particles included, do not shorten the step: neither the bound nor the truth.
TEST(CriticalStep, WeightsDoNotShortenIt) {
  const ContactBond law{{7.0, 2.0}, kUnbreakable, kUnbreakable};
  const Model packing = test::rows_of(5, 6);
  const double unweighted = critical_step(test::assemble(packing, 2.0), law.stiffness);
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    std::vector<double> centres(packing.discs.x.size()), midpoints(packing.bonds.size());
    test::fill_randomly(centres, 1.0, seed);
    test::fill_randomly(midpoints, 1.0, seed + 10);
    for (double& weight : centres) weight = weight < -0.7 ? 0 : std::abs(weight);
    for (double& weight : midpoints) weight = std::pow(std::abs(weight), 4);
    const Assembly a = test::assemble(packing, 2.0, {centres, midpoints, 1e-3});
    ASSERT_LT(a.particles.size(), packing.discs.x.size());
    EXPECT_GE(critical_step(a, law.stiffness), unweighted * (1 - 1e-14));
    EXPECT_GE(exact_step(law, a), unweighted);
  }
}

// Just below the exact step small vibrations stay bounded, just above it they grow: the exact step is the
// limit.
TEST(CriticalStep, ExactStepIsTheLimitOfStability) {
  const ContactBond law{{7.0, 2.0}, kUnbreakable, kUnbreakable};
  const auto peak = [&](double factor) {
    Assembly a = test::assemble(test::rows_of(4, 5), 2.0);
    test::fill_randomly(a.particles.vx, 1e-9, 5);
    test::fill_randomly(a.particles.vy, 1e-9, 6);
    const double dt = factor * exact_step(law, a);
    test::Ledger ledger;
    double most = 0;
    for (int n = 0; n < 1000; ++n) {
      test::step(law, dt, false, a, ledger);
      for (const double v : a.particles.vx) most = std::max(most, std::abs(v));
      if (most > 1e-6) break;
    }
    return most;
  };
  EXPECT_LT(peak(0.99), 1e-7);
  EXPECT_GT(peak(1.01), 1e-6);
}

}  // namespace
}  // namespace adit::dem::critical_step_test
