// The three solves against their definitions, and the properties that the method rests on, over random
// interfaces.
#include "coupler/bridging/solves/multipliers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <limits>

#include "coupler/bridging/solves/split.hpp"
#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/coupler/participants/interface_fixture.hpp"

namespace adit::coupler::multipliers_test {
namespace {

using test::component;
using test::Dense;

constexpr std::array kAll = {scene::CONSISTENT, scene::LUMPED, scene::SPLIT};

// A correction of random velocities: grid velocities that the coarse side really has, so that N V is in its
// space.
struct Correction {
  test::RandomInterface interface;
  std::vector<double> own, coarse, fine, multipliers;  // V, N V, v, λ

  Correction(scene::Solve kind, unsigned seed, double decades = 2)
      : interface(test::random_interface(seed, decades)),
        own(test::random_vector(seed + 1, 2 * interface.coarse.own_points())),
        coarse(interface.fine_masses.size()),
        fine(test::random_vector(seed + 2, coarse.size())),
        multipliers(coarse.size()) {
    interface.coarse.interpolate(own, coarse);
    make_multiplier_solve(kind, interface.coarse, interface.fine_masses,
                          kind == scene::SPLIT ? interface.decay : std::vector<double>{})
        ->solve(coarse, fine, multipliers);
  }
  Eigen::VectorXd lambda(int direction) const { return component(multipliers, direction); }
  Eigen::VectorXd gap(int direction) const {
    return component(coarse, direction) - component(fine, direction);
  }
  Eigen::VectorXd corrected_own(int direction) const {
    const Dense d(interface, direction);
    return component(own, direction) - d.inverse_coarse.cwiseProduct(d.n.transpose() * lambda(direction));
  }
  Eigen::VectorXd corrected_fine(int direction) const {
    return component(fine, direction) + lambda(direction).cwiseQuotient(Dense(interface, direction).fine);
  }
};

// Requirement: the consistent solve solves A λ = g, though it never forms A: continuity is exact.
RC_GTEST_PROP(ConsistentSolve, SolvesTheSystemOfThePaper, ()) {
  const Correction c(scene::CONSISTENT, *rc::gen::inRange(0U, 1U << 30), 4);
  for (const int direction : {0, 1}) {
    const Eigen::MatrixXd a = Dense(c.interface, direction).system();
    const Eigen::VectorXd l = c.lambda(direction), residual = a * l - c.gap(direction);
    RC_ASSERT(residual.cwiseAbs().maxCoeff() <= 1e-12 * (a.cwiseAbs() * l.cwiseAbs()).maxCoeff());
  }
}

// Requirement: the lumped solve divides by the row sums of |A|, which are those of A where N has no negative
// entry.
RC_GTEST_PROP(LumpedSolve, DividesByTheRowSums, ()) {
  const Correction c(scene::LUMPED, *rc::gen::inRange(0U, 1U << 30), 4);
  for (const int direction : {0, 1}) {
    const Dense d(c.interface, direction);
    const Eigen::MatrixXd n = d.n.cwiseAbs();
    const Eigen::VectorXd row_sums =
        n * d.inverse_coarse.cwiseProduct(n.transpose() * Eigen::VectorXd::Ones(n.rows())) +
        d.fine.cwiseInverse();
    const Eigen::VectorXd expected = c.gap(direction).cwiseQuotient(row_sums);
    RC_ASSERT((c.lambda(direction) - expected).cwiseAbs().maxCoeff() <=
              1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

// Requirement: no correction raises the kinetic energy, whose change is −λᵀg + ½ λᵀAλ.
RC_GTEST_PROP(AllSolves, NeverRaiseTheKineticEnergy, ()) {
  const auto seed = *rc::gen::inRange(0U, 1U << 30);
  for (const scene::Solve kind : kAll) {
    const Correction c(kind, seed);
    for (const int direction : {0, 1}) {
      const Eigen::VectorXd l = c.lambda(direction);
      const double given = l.dot(Dense(c.interface, direction).system() * l);
      RC_ASSERT(-l.dot(c.gap(direction)) + 0.5 * given <= 1e-9 * given);
    }
  }
}

// Requirement: both sides together keep their linear momentum, because rows of N sum to 1.
RC_GTEST_PROP(AllSolves, KeepLinearMomentum, ()) {
  const auto seed = *rc::gen::inRange(0U, 1U << 30);
  for (const scene::Solve kind : kAll) {
    const Correction c(kind, seed);
    for (const int direction : {0, 1}) {
      const Eigen::VectorXd l = c.lambda(direction);
      const double on_coarse = (Dense(c.interface, direction).n.transpose() * l).sum();
      RC_ASSERT(std::abs(on_coarse - l.sum()) <= 1e-12 * l.cwiseAbs().sum());
    }
  }
}

// Requirement: after the split solve the fine side moves, in the coarse side's space, exactly as the coarse
// side does, where that is free to.
RC_GTEST_PROP(SplitSolve, IsContinuousInTheCoarseSpace, ()) {
  const Correction c(scene::SPLIT, *rc::gen::inRange(0U, 1U << 30));
  const Dense d(c.interface, 0);
  const Eigen::VectorXd residual = d.projection() * c.corrected_fine(0) - d.n * c.corrected_own(0);
  RC_ASSERT(residual.cwiseAbs().maxCoeff() <= 1e-6);
}

// Requirement: the coarse side is corrected as by the consistent solve.
RC_GTEST_PROP(SplitSolve, CorrectsTheCoarseSideLikeTheConsistentOne, ()) {
  const auto seed = *rc::gen::inRange(0U, 1U << 30);
  const Correction split(scene::SPLIT, seed), consistent(scene::CONSISTENT, seed);
  for (const int direction : {0, 1})
    RC_ASSERT((split.corrected_own(direction) - consistent.corrected_own(direction)).cwiseAbs().maxCoeff() <=
              1e-6);
}

// Requirement: of the fine motion (1 − Q) v exactly (1 − Q) D (1 − Q) v goes.
RC_GTEST_PROP(SplitSolve, TakesItsShareOfTheFineMotion, ()) {
  const Correction c(scene::SPLIT, *rc::gen::inRange(0U, 1U << 30));
  for (const int direction : {0, 1}) {
    const Dense d(c.interface, direction);
    const Eigen::MatrixXd fine = Eigen::MatrixXd::Identity(d.n.rows(), d.n.rows()) - d.projection();
    const Eigen::VectorXd share = Eigen::Map<const Eigen::VectorXd>(c.interface.decay.data(), d.n.rows());
    const Eigen::VectorXd before = fine * component(c.fine, direction);
    const Eigen::VectorXd expected = before - fine * share.cwiseProduct(before);
    RC_ASSERT((fine * c.corrected_fine(direction) - expected).cwiseAbs().maxCoeff() <= 1e-6);
  }
}

// Requirement: decay is a rate per second: two steps of dt take what one of 2 dt takes.
RC_GTEST_PROP(Decay, DoesNotDependOnTheStep, ()) {
  const double across = *rc::gen::inRange(0, 1001) / 1000.0, dt = *rc::gen::inRange(1, 1000) * 1e-6;
  const double rate = *rc::gen::inRange(0, 100000);
  const double once = decay_per_step({{across}}, rate, 2 * dt)[0],
               half = decay_per_step({{across}}, rate, dt)[0];
  RC_ASSERT(std::abs((1 - half) * (1 - half) - (1 - once)) <= 1e-14);
  RC_ASSERT(once >= 0 && once <= 1);
}

Interpolation one_point(double inverse_mass) {
  return {{0, 1}, {0}, {1.0}, {inverse_mass, inverse_mass}};
}

// Requirement: two masses that meet at one point move on with their common momentum (inelastic impact).
TEST(ConsistentSolve, JoinsTwoMassesAsAnInelasticImpact) {
  const std::vector<double> coarse = {4.0, -8.0}, fine = {0, 0}, masses = {1, 1};
  std::vector<double> multipliers(2);
  make_multiplier_solve(scene::CONSISTENT, one_point(1.0 / 3), masses, {})->solve(coarse, fine, multipliers);
  EXPECT_NEAR(multipliers[0], 4.0 * 0.75, 1e-15);  // g · m M / (m + M)
  EXPECT_NEAR(multipliers[1], -8.0 * 0.75, 1e-15);
}

void expect_refusal(const Interpolation& coarse, const std::vector<double>& masses, const std::string& text) {
  test::expect_refusal([&] { make_multiplier_solve(scene::CONSISTENT, coarse, masses, {}); },
                       "interface.overlap", text);
}

// Requirement: a particle in the overlap whose motion is prescribed is refused by name.
TEST(Multipliers, RefuseAPrescribedParticleInTheOverlap) {
  expect_refusal(one_point(1), {1, std::numeric_limits<double>::infinity()}, "prescribed");
}

// Requirement: so is a grid that is finer than the particles that it is to follow.
TEST(Multipliers, RefuseACoarseSideThatIsTheFinerOne) {
  std::vector<std::uint32_t> row_starts = {0}, columns;
  for (std::uint32_t k = 0; k < 6; ++k) {  // two coarse points of its own for each coupling point
    columns.insert(columns.end(), {2 * k, 2 * k + 1});
    row_starts.push_back(2 * (k + 1));
  }
  expect_refusal({row_starts, columns, std::vector<double>(12, 0.5), std::vector<double>(24, 1.0)},
                 std::vector<double>(12, 1.0), "finer");
}

// Requirement: two models whose points coincide are tied point by point.
TEST(Multipliers, TieMatchingPoints) {
  std::vector<std::uint32_t> row_starts = {0}, columns;
  for (std::uint32_t k = 0; k < 6; ++k) {
    columns.push_back(k);
    row_starts.push_back(k + 1);
  }
  const Interpolation coarse(row_starts, columns, std::vector<double>(6, 1.0),
                             std::vector<double>(12, 1.0 / 3));
  const std::vector<double> moving(12, 4.0), still(12, 0.0), masses(12, 1.0);
  for (const scene::Solve kind : kAll) {
    std::vector<double> multipliers(12);
    make_multiplier_solve(kind, coarse, masses, std::vector<double>(6, 0.5))
        ->solve(moving, still, multipliers);
    for (const double multiplier : multipliers) EXPECT_NEAR(multiplier, 3.0, 1e-9) << scene::Solve_Name(kind);
  }
}

// Requirement: coupling points may lie on the edges of zones, where a coarse point has the share 0. Of three
// along a zone, two lie at its ends; all move on with it.
TEST(SplitSolve, IsContinuousWhereCouplingPointsLieOnEdgesOfZones) {
  const Interpolation coarse({0, 2, 4, 6}, {0, 1, 0, 1, 0, 1}, {1, 0, 0.5, 0.5, 0, 1},
                             std::vector<double>(4, 0.5));
  const std::vector<double> moving(6, 4.0), still(6, 0.0), masses(6, 1.0);
  std::vector<double> multipliers(6), own(4), lost(6);
  make_multiplier_solve(scene::SPLIT, coarse, masses, std::vector<double>(3, 0.5))
      ->solve(moving, still, multipliers);
  coarse.gather(multipliers, own);
  coarse.divide_by_mass(own);
  coarse.interpolate(own, lost);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(multipliers[i] / masses[i], 4 - lost[i], 1e-9) << i;
}

// Requirement: factors stay sparse: in a plane with 10⁵ coupling points they hold a few dozen numbers a grid
// point.
TEST(Multipliers, StaySparseWithAHundredThousandCouplingPoints) {
  const std::size_t columns = 160, rows = 40,
                    per_zone = 4;  // a strip of zones, 4 x 4 coupling points in each
  std::vector<std::uint32_t> row_starts = {0}, own;
  std::vector<double> values;
  for (std::size_t j = 0; j < rows * per_zone; ++j)
    for (std::size_t i = 0; i < columns * per_zone; ++i) {
      const double x = (static_cast<double>(i) + 0.5) / per_zone,
                   y = (static_cast<double>(j) + 0.5) / per_zone;
      const auto a = static_cast<std::size_t>(x), b = static_cast<std::size_t>(y);
      const double s = x - static_cast<double>(a), t = y - static_cast<double>(b);
      const auto lower = static_cast<std::uint32_t>(b * (columns + 1) + a);
      const auto upper = static_cast<std::uint32_t>(lower + columns + 1);
      own.insert(own.end(), {lower, lower + 1, upper + 1, upper});
      values.insert(values.end(), {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t});
      row_starts.push_back(static_cast<std::uint32_t>(own.size()));
    }
  const std::size_t points = row_starts.size() - 1, own_points = (columns + 1) * (rows + 1);
  ASSERT_GE(points, 100000U);
  const Interpolation coarse(row_starts, own, values, std::vector<double>(2 * own_points, 0.1));
  const std::vector<double> masses(2 * points, 1.0);
  for (const scene::Solve kind : {scene::CONSISTENT, scene::SPLIT}) {
    const auto solve = make_multiplier_solve(kind, coarse, masses, std::vector<double>(points, 0.1));
    EXPECT_LE(solve->cost().factor_bytes, 2 * 100 * 12 * own_points) << scene::Solve_Name(kind);
    std::vector<double> ones(2 * points, 1.0), twos(2 * points, 2.0), multipliers(2 * points);
    solve->solve(ones, twos, multipliers);
    for (const double multiplier : multipliers) ASSERT_LT(multiplier, 0);
  }
}

}  // namespace
}  // namespace adit::coupler::multipliers_test
