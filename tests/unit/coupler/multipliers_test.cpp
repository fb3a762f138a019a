// Both solves against their definitions, and the properties that the method rests on, over random interfaces.
#include "coupler/bridging/multipliers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "protocol/errors.hpp"
#include "tests/unit/coupler/interface_fixture.hpp"

namespace adit::coupler {
namespace {

using test::component;

test::RandomInterface any_interface(unsigned seed) {
  const auto grid_points = 1 + seed % 9;
  return test::random_interface(seed, 1 + seed % 40, grid_points, 4.0);
}

std::vector<double> solve(scene::Solve kind, const test::RandomInterface& interface,
                          const std::vector<double>& gap) {
  std::vector<double> multipliers(gap.size());
  make_multiplier_solve(kind, interface.grid, interface.particles)->solve(gap, multipliers);
  return multipliers;
}

// Requirement: the consistent solve solves A λ = g, though it never forms A.
RC_GTEST_PROP(ConsistentSolve, SolvesTheSystemOfThePaper, (unsigned seed)) {
  const auto interface = any_interface(seed);
  const auto gap = test::random_vector(seed + 1, 2 * interface.grid.coupling_points());
  const auto multipliers = solve(scene::CONSISTENT, interface, gap);
  for (int direction = 0; direction < 2; ++direction) {
    const Eigen::MatrixXd a = test::system_matrix(interface, direction);
    const Eigen::VectorXd residual = a * component(multipliers, direction) - component(gap, direction);
    RC_ASSERT(residual.cwiseAbs().maxCoeff() <= 1e-11);
  }
}

// Requirement: the lumped solve divides by the row sums of A.
RC_GTEST_PROP(LumpedSolve, DividesByTheRowSums, (unsigned seed)) {
  const auto interface = any_interface(seed);
  const auto gap = test::random_vector(seed + 1, 2 * interface.grid.coupling_points());
  const auto multipliers = solve(scene::LUMPED, interface, gap);
  for (int direction = 0; direction < 2; ++direction) {
    const Eigen::VectorXd row_sums = test::system_matrix(interface, direction).rowwise().sum();
    const Eigen::VectorXd expected = component(gap, direction).cwiseQuotient(row_sums);
    RC_ASSERT((component(multipliers, direction) - expected).cwiseAbs().maxCoeff() <=
              1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

// Requirement: no correction of either solve raises the kinetic energy, whose change is −λᵀg + ½ λᵀAλ.
RC_GTEST_PROP(BothSolves, NeverRaiseTheKineticEnergy, (unsigned seed)) {
  const auto interface = any_interface(seed);
  const auto gap = test::random_vector(seed + 1, 2 * interface.grid.coupling_points());
  for (const scene::Solve kind : {scene::CONSISTENT, scene::LUMPED}) {
    const auto multipliers = solve(kind, interface, gap);
    for (int direction = 0; direction < 2; ++direction) {
      const Eigen::VectorXd l = component(multipliers, direction), g = component(gap, direction);
      const double work = l.dot(g);
      const double change = -work + 0.5 * l.dot(test::system_matrix(interface, direction) * l);
      RC_ASSERT(change <= 1e-12 * std::abs(work));
    }
  }
}

// Requirement: both sides together keep their linear momentum, because rows of N sum to 1.
RC_GTEST_PROP(BothSolves, KeepLinearMomentum, (unsigned seed)) {
  const auto interface = any_interface(seed);
  const auto gap = test::random_vector(seed + 1, 2 * interface.grid.coupling_points());
  for (const scene::Solve kind : {scene::CONSISTENT, scene::LUMPED}) {
    const auto multipliers = solve(kind, interface, gap);
    std::vector<double> on_grid(2 * interface.grid.own_points()),
        on_particles(2 * interface.particles.own_points());
    interface.grid.gather(multipliers, on_grid);
    interface.particles.gather(multipliers, on_particles);
    for (int direction = 0; direction < 2; ++direction) {
      const double scale = component(multipliers, direction).cwiseAbs().sum();
      RC_ASSERT(std::abs(component(on_grid, direction).sum() - component(on_particles, direction).sum()) <=
                1e-13 * scale);
    }
  }
}

wire::Operator one_point(double inverse_mass_x, double inverse_mass_y) {
  wire::Operator op;
  op.add_row_starts(0);
  op.add_row_starts(1);
  op.add_columns(0);
  op.add_values(1);
  op.add_inverse_masses(inverse_mass_x);
  op.add_inverse_masses(inverse_mass_y);
  return op;
}

// Requirement: two masses that meet at one point move on with their common momentum (inelastic impact).
TEST(ConsistentSolve, JoinsTwoMassesAsAnInelasticImpact) {
  const Interpolation heavy(one_point(1.0 / 3, 1.0 / 3), 1, "a"), light(one_point(1, 1), 1, "b");
  const std::vector<double> gap = {4.0, -8.0};
  std::vector<double> multipliers(2);
  make_multiplier_solve(scene::CONSISTENT, heavy, light)->solve(gap, multipliers);
  EXPECT_NEAR(multipliers[0], 4.0 * 0.75, 1e-15);  // g · m M / (m + M)
  EXPECT_NEAR(multipliers[1], -8.0 * 0.75, 1e-15);
}

// Requirement: a particle in the overlap whose motion is prescribed is refused by name.
TEST(Multipliers, RefuseAPrescribedParticleInTheOverlap) {
  const Interpolation grid(one_point(1, 1), 1, "a"), held(one_point(1, 0), 1, "b");
  try {
    make_multiplier_solve(scene::CONSISTENT, grid, held);
    FAIL() << "was accepted";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "interface.overlap");
    EXPECT_NE(std::string(error.what()).find("prescribed"), std::string::npos);
  }
}

}  // namespace
}  // namespace adit::coupler
