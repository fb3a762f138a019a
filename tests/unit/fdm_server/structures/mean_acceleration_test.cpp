// Requirements on structures in steps that are too long for central differences.
#include <gtest/gtest.h>

#include <algorithm>

#include "fdm_server/structures/mean_acceleration.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::mean_acceleration_test {
namespace {

Eigen::Index number(const Freedom& freedom, std::size_t points) {
  const auto at = static_cast<Eigen::Index>(freedom.number), first = static_cast<Eigen::Index>(2 * points);
  return freedom.kind == Freedom::kRotation ? first + at : 2 * at + freedom.kind;
}

Eigen::MatrixXd assembled(std::span<const StrainForm> strains, std::size_t points, std::size_t rotations) {
  const auto size = static_cast<Eigen::Index>(2 * points + rotations);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  for (const StrainForm& strain : strains)
    for (const auto& row : strain.shares)
      for (const auto& column : strain.shares)
        k(number(row.of, points), number(column.of, points)) += strain.stiffness * row.factor * column.factor;
  return k;
}

// The strains of beams make the stiffness that their forces show; a bar's that of its axis.
TEST(MeanAcceleration, KnowsTheStiffnessOfTheKernels) {
  Frame frame(circle(3, 24), true, wall(0.3));
  const std::size_t rotations = frame.structures.rotations().size();
  const auto measured = stiffness(frame.structures.beams(), 24, rotations);
  const auto strains = frame.structures.strains(frame.structures.standing());
  EXPECT_LE((assembled(strains, 24, rotations) - measured).norm(), 1e-14 * measured.norm());

  const Bar bar({0, 1}, chord(0, 0, 3, 4), {2e8, 1e9, 1});
  const StrainForm strain = bar.strain();
  Eigen::VectorXd along(4);
  along << -0.6, -0.8, 0.6, 0.8;
  EXPECT_LE((assembled({&strain, 1}, 2, 0) - 4e7 * along * along.transpose()).norm(), 1e-7);
}

// A free ring with a joint: every mode turns by 2 atan(w dt/2) in a step, as that of mean acceleration,
// though the step is 30 times the critical one of central differences.
TEST(MeanAcceleration, ModesTurnAtTheirFrequency) {
  const Frame frame(circle(3, 24), true, wall(0.3), {{5, 1e7, 1e9}});
  Continuum continuum = frame.continuum({});
  const Structures& structures = continuum.structures();
  const std::size_t points = 24, rotations = structures.rotations().size();
  const Eigen::MatrixXd k = assembled(structures.strains(structures.standing()), points, rotations);
  Eigen::VectorXd m(2 * points + rotations);
  for (std::uint32_t i = 0; i < points; ++i) m[2 * i] = m[2 * i + 1] = frame.masses()[i];
  for (std::uint32_t i = 0; i < rotations; ++i) m[2 * points + i] = 1 / structures.inverse_inertia(i);
  const Eigen::VectorXd root = m.array().rsqrt();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(root.asDiagonal() * k * root.asDiagonal());

  const double dt = 30 * structures.critical_step();
  continuum.step({0, dt});
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(m.size());
  for (std::uint32_t i = 0; i < points; ++i) {
    velocity[2 * i] = continuum.vx()[i] = std::sin(1.7 * i * i);
    velocity[2 * i + 1] = continuum.vy()[i] = std::cos(2.3 * i * i);
  }
  const auto modal = [&](const Eigen::VectorXd& of) -> Eigen::VectorXd {
    return modes.eigenvectors().transpose() * root.cwiseInverse().cwiseProduct(of);
  };
  const Eigen::VectorXd first = modal(velocity) * dt;

  constexpr int kSteps = 200;
  for (std::uint64_t n = 1; n <= kSteps; ++n) continuum.step({n, dt});
  Eigen::VectorXd now(m.size());
  for (std::uint32_t i = 0; i < points; ++i) {
    now[2 * i] = continuum.ux()[i];
    now[2 * i + 1] = continuum.uy()[i];
  }
  for (std::uint32_t i = 0; i < rotations; ++i) now[2 * points + i] = structures.rotations()[i];
  const Eigen::VectorXd found = modal(now);
  int stiff = 0;
  for (Eigen::Index mode = 3; mode < m.size(); ++mode) {  // after the rigid motions
    const double turn = 2 * std::atan(std::sqrt(modes.eigenvalues()[mode]) * dt / 2);
    stiff += turn > 3;
    EXPECT_NEAR(found[mode], first[mode] * std::sin(kSteps * turn) / std::sin(turn), 1e-8 * first.norm())
        << mode;
  }
  EXPECT_GE(stiff, 10);
}

// Prescribed ends pull the rest along: the free end of a cantilever whose foot moves steadily follows it, and
// the work of the foot is what the cantilever has, while the foot is pushed into motion and stopped.
TEST(MeanAcceleration, PrescribedPointsDoTheWork) {
  Frame frame(line(4, 8, 0.3), false, wall(0.3), {}, {true, false});
  const auto push = [](double t) { return t < 0.2 ? std::pow(std::sin(std::numbers::pi * t / 0.2), 2) : 0; };
  Continuum continuum = frame.continuum(
      {}, {PrescribedMotion{{0}, Axis::kX, 0.5, push}, PrescribedMotion{{0}, Axis::kY, -1.0, push}});
  const double dt = 20 * continuum.structures().critical_step();
  Energies first{}, last{};
  continuum.step({0, dt}, &first);
  double peak = 0, drift = 0;
  for (std::uint64_t n = 1; static_cast<double>(n) * dt < 0.5; ++n) {
    continuum.step({n, dt}, &last);
    peak = std::max(peak, last.kinetic);
    drift = std::max(drift, std::abs(last.kinetic + last.strain - last.external_work -
                                     (first.kinetic + first.strain - first.external_work)));
  }
  EXPECT_LE(drift, 1e-11 * peak);
  EXPECT_NEAR(continuum.ux()[0], 0.05, 1e-3 * 0.05);
  EXPECT_NEAR(continuum.ux()[8], 0.05, 0.2 * 0.05);  // the blow of the foot rings on
}

}  // namespace
}  // namespace adit::fdm::test::mean_acceleration_test
