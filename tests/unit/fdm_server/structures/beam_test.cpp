// Requirements on one beam and on its critical step.
#include <gtest/gtest.h>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::beam_test {
namespace {

constexpr double kThickness = 0.4;

// The element is Timoshenko's exact one, and Euler's and Bernoulli's without shear flexibility.
TEST(Beam, StiffnessIsTheTextbooks) {
  for (const bool shear : {true, false})
    for (const double length : {0.3, 1.0, 4.0}) {
      const Section section = wall(kThickness, shear);
      const Frame frame(line(length, 1), false, section);
      const auto k = stiffness(frame.structures.beams(), 2, 2);
      const double l = length, phi = 12 * section.bending / (section.shear * l * l);
      const double c = section.bending / (l * l * l * (1 + phi)), e = section.axial / l;
      Eigen::MatrixXd expected(6, 6);  // Przemieniecki 1968, eq. 5.116; order u1 w1 u2 w2 theta1 theta2
      expected << e, 0, -e, 0, 0, 0,   //
          0, 12 * c, 0, -12 * c, 6 * c * l, 6 * c * l,                                //
          -e, 0, e, 0, 0, 0,                                                          //
          0, -12 * c, 0, 12 * c, -6 * c * l, -6 * c * l,                              //
          0, 6 * c * l, 0, -6 * c * l, (4 + phi) * c * l * l, (2 - phi) * c * l * l,  //
          0, 6 * c * l, 0, -6 * c * l, (2 - phi) * c * l * l, (4 + phi) * c * l * l;
      EXPECT_LE((k - expected).norm(), 1e-13 * expected.norm()) << length;
    }
}

// Rigid motion, turned by any angle, strains nothing.
TEST(Beam, RigidMotionCausesNoForce) {
  const Frame frame(line(1.7, 1, 0.8), false, wall(kThickness));
  const auto k = stiffness(frame.structures.beams(), 2, 2);
  Eigen::VectorXd rigid(6);
  rigid << 0.3, -0.2, 0.3 - frame.grid.y[1], -0.2 + frame.grid.x[1], 1, 1;
  EXPECT_LE((k * rigid).norm(), 1e-14 * k.norm());
}

// The step is the exact one of the free beam; rotation never governs: it is l/c with shear flexibility,
// and l/c / sqrt(1 + 12 r^2/l^2) without.
TEST(Beam, CriticalStepIsThatOfTheAxialWave) {
  for (const bool shear : {true, false})
    for (const double length : {0.05, 0.2, 0.4, 1.0, 10.0}) {
      const Section section = wall(kThickness, shear);
      const Frame frame(line(length, 1, 0.5), false, section);
      const auto beams = frame.structures.beams();
      const auto m = inertias(beams, 2, 2);
      const double exact = 2 / std::sqrt(eigenvalues(stiffness(beams, 2, 2), m, all(m)).maxCoeff());
      EXPECT_NEAR(frame.structures.critical_step(), exact, 1e-12 * exact);
      const double wave = length / std::sqrt(section.axial / section.mass);
      const double ratio = kThickness / length;
      EXPECT_NEAR(exact, wave / (shear ? 1 : std::sqrt(1 + ratio * ratio)), 1e-9 * wave) << length;
    }
}

// Ground and lining together: the smaller of their steps is a lower bound of the assembled one.
TEST(Beam, StepOfGroundAndLiningTogetherIsBounded) {
  const Grid grid = make_grid({0, 4, 0, 2, 4, 2});
  for (const double young : {1e8, 30e9, 3e12}) {
    const PlaneLaw law = plane_strain(young, 0.3);
    Structures structures;
    const Path floor{{5, 6, 7, 8, 9}, false};
    add_lining({"floor", floor, wall(kThickness), {{2, 1e9, 1e9}}, false, false}, grid, structures);
    auto ground = lumped_masses(grid, ones(grid), 2000);
    const std::size_t points = grid.x.size(), rotations = structures.rotations().size();
    Eigen::MatrixXd k = stiffness(structures.beams(), points, rotations);
    k.topLeftCorner(2 * points, 2 * points) += assembled_stiffness(ZoneKind::kAssumedStrain, grid, law);
    Eigen::VectorXd m = inertias(structures.beams(), points, rotations);
    for (std::size_t i = 0; i < points; ++i) m.segment<2>(2 * i).array() += ground[i];
    const double exact = 2 / std::sqrt(eigenvalues(k, m, all(m)).maxCoeff());
    const double bound =
        std::min(structures.critical_step(), critical_step(ZoneKind::kAssumedStrain, grid, law, 2000));
    EXPECT_LE(bound, exact);
    EXPECT_GE(bound, 0.5 * exact);
  }
}

// Bending frequencies of a simply supported beam, in order of two: Euler-Bernoulli's and Timoshenko's, with
// the rotary inertia that the beams have, three times the section's.
TEST(Beam, FrequenciesConvergeToTheTheory) {
  constexpr double kLength = 10;
  for (const bool shear : {true, false})
    for (const int mode : {1, 2, 3}) {
      const Section section = wall(kThickness, shear);
      // Timoshenko: w = W sin kx, theta = T cos kx; [G k^2 - m w2, -G k; -G k, EI k^2 + G - J w2] singular
      const double k = mode * std::numbers::pi / kLength, g = shear ? section.shear : 1e6 * section.axial;
      const double a = section.mass * 3 * section.rotary;
      const double b = section.mass * (section.bending * k * k + g) + 3 * section.rotary * g * k * k;
      const double c = g * k * k * section.bending * k * k;
      const double exact = 2 * c / (b + std::sqrt(b * b - 4 * a * c));
      std::array<double, 2> error{};
      for (const std::size_t n : {16, 32}) {
        const Frame frame(line(kLength, n), false, section);
        const auto beams = frame.structures.beams();
        const auto m = inertias(beams, n + 1, n + 1);
        std::vector<Eigen::Index> free;
        for (Eigen::Index i = 0; i < m.size(); ++i)
          if (i >= Eigen::Index(2 * n + 2) || (i % 2 == 1 && i > 1 && i < Eigen::Index(2 * n + 1)))
            free.push_back(i);
        const double found = eigenvalues(stiffness(beams, n + 1, n + 1), m, free)[mode - 1];
        error[n == 32] = std::abs(std::sqrt(found / exact) - 1);
      }
      EXPECT_LE(error[1], 1e-3 * mode * mode);
      EXPECT_GE(std::log2(error[0] / error[1]), 1.9) << mode << " " << shear;
      if (!shear) {  // Euler and Bernoulli, but for rotary inertia: slower by 3/2 (k r)^2
        const double euler = k * k * std::sqrt(section.bending / section.mass);
        const double kr = k * kThickness / std::sqrt(12.0);
        EXPECT_NEAR(std::sqrt(exact) / euler, 1 - 1.5 * kr * kr, 4 * std::pow(kr, 4) + 1e-5);
      }
    }
}

}  // namespace
}  // namespace adit::fdm::test::beam_test
