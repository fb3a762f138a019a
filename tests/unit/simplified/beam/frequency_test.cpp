// Natural frequencies of a uniform tube on an elastic foundation against closed forms, to 1e-4.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "simplified/beam/elements/soil_springs.hpp"
#include "simplified/beam/elements/structure.hpp"
#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::frequency_test {
namespace {

constexpr double kSoil = 1.661e8, kLength = 400, kMass = 4.3e5;

Eigen::MatrixXd dense(const BlockTridiagonal& matrix) {
  const auto size = static_cast<Eigen::Index>(kDofs * matrix.nodes());
  Eigen::MatrixXd result(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, j);
    matrix.multiply({unit.data(), kDofs * matrix.nodes()}, {result.col(j).data(), kDofs * matrix.nodes()});
  }
  return result;
}

// The circular frequencies of the structure on its springs at rest, ascending [rad/s]. Fixed portals do not
// move.
std::vector<double> frequencies(const Tunnel& tunnel) {
  check(tunnel);
  const Structure structure(tunnel);
  SoilSprings soil(tunnel, structure.mesh, structure.elements);
  const std::vector<double> rest(structure.dofs());
  std::vector<double> forces(structure.dofs());
  GroundState ground;
  for (auto* kind : {&ground.displacement, &ground.velocity})
    for (auto& values : *kind) values.assign(soil.chainages().size() + 2 * SoilSprings::first_support, 0.0);
  ground.pressure_ratio = ground.displacement[kAxial];
  // Newmark's tangents are those of the springs; those of mean forces are half as large.
  soil.evaluate(newmark(), rest, rest, ground, forces);
  BlockTridiagonal stiffness = structure.stiffness;
  soil.update_tangents(stiffness);
  std::vector<Eigen::Index> free;
  for (std::size_t dof = 0; dof < structure.dofs(); ++dof)
    if (std::ranges::find(structure.fixed_nodes, dof / kDofs) == structure.fixed_nodes.end())
      free.push_back(static_cast<Eigen::Index>(dof));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      dense(stiffness)(free, free), dense(structure.mass)(free, free), Eigen::EigenvaluesOnly);
  EXPECT_EQ(solver.info(), Eigen::Success);
  const Eigen::VectorXd omega = solver.eigenvalues().cwiseSqrt();
  return {omega.begin(), omega.end()};
}

// ω² = (K + EI β⁴)/m with cosh βL cos βL = 1, for free and for clamped ends; free ends also move rigidly (β =
// 0, twice).
std::vector<double> bending(double inertia, bool free) {
  std::vector<double> omega;
  for (const double root :
       {4.730040744862704, 7.853204624095838, 10.99560783800167, 14.13716549125746, 17.27875965739948})
    omega.push_back(std::sqrt((kSoil + kYoung * inertia * std::pow(root / kLength, 4)) / kMass));
  if (free) omega.insert(omega.end(), 2, std::sqrt(kSoil / kMass));
  return omega;
}

// ω² = (K + EA (nπ/L)²)/m, n from 0 between free and from 1 between fixed ends.
std::vector<double> axial(bool free) {
  std::vector<double> omega;
  for (int n = free ? 0 : 1; n < 3; ++n)
    omega.push_back(std::sqrt((kSoil + kYoung * kArea * std::pow(n * kPi / kLength, 2)) / kMass));
  return omega;
}

TEST(Frequencies, OfATubeOnAnElasticFoundation) {
  for (const bool free : {true, false}) {
    Tunnel tunnel = immersed_tube(0, kLength, 4, kSoil);
    tunnel.start = tunnel.end = free ? Portal::kFree : Portal::kFixed;
    std::vector<double> expected = axial(free);
    for (const double inertia : {kInertia, 2.5e3}) {
      const auto plane = bending(inertia, free);
      expected.insert(expected.end(), plane.begin(), plane.end());
    }
    std::sort(expected.begin(), expected.end());
    const auto found = frequencies(tunnel);
    for (int i = 0; i < 7; ++i)
      EXPECT_NEAR(found[i] / expected[i], 1, 1e-4) << (free ? "free " : "fixed ") << i;
  }
}

// A rigid tube turning on its springs: ω² = K L³/12 / (m L³/12 + ρ I L), with rotary inertia where shear is
// taken along.
TEST(Frequencies, RotaryInertiaOfARigidTube) {
  const double length = 40;
  Tunnel tunnel = immersed_tube(0, length, 10, kSoil);
  Section& section = tunnel.sections[0];
  section.youngs_modulus = section.shear_modulus = 1e15;
  section.shear_area_lateral = 60;
  section.inertia_vertical = kInertia;
  tunnel.soil[0].springs[kVertical].stiffness = tunnel.soil[1].springs[kVertical].stiffness = 100 * kSoil;
  tunnel.soil[0].springs[kAxial].stiffness = tunnel.soil[1].springs[kAxial].stiffness = 100 * kSoil;
  const double turning = std::pow(length, 3) / 12;
  const auto found = frequencies(tunnel);
  EXPECT_NEAR(found[0], std::sqrt(kSoil * turning / (kMass * turning + kMass / kArea * kInertia * length)),
              1e-4 * found[0]);
  EXPECT_NEAR(found[1], std::sqrt(kSoil / kMass), 1e-4 * found[1]);
}

}  // namespace
}  // namespace adit::simplified::beam::frequency_test
