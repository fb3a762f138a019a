// Requirements on bending: the 10 m x 1 m cantilever in zones of 0.5 m x 0.25 m.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::bending_test {
namespace {

constexpr double kLength = 10, kHeight = 1, kInertia = 1.0 / 12, kShearFactor = 5.0 / 6;
constexpr double kShearModulus = kYoung / (2 * (1 + kPoisson));

// Stiffness and masses of the cantilever's free degrees of freedom; the end x = 10 m is fixed.
struct Cantilever {
  Eigen::MatrixXd stiffness;
  Eigen::VectorXd masses;
  Eigen::VectorXd tip;  // unit force downwards along the free end's zone edges, by length
};

Cantilever cantilever(ZoneKind kind, const PlaneLaw& law, std::uint32_t zones_x = 20,
                      std::uint32_t zones_y = 4) {
  const Grid grid = make_grid({0, kLength, 0, kHeight, zones_x, zones_y});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    if (grid.x[i] < kLength) free.insert(free.end(), {Eigen::Index(2 * i), Eigen::Index(2 * i + 1)});
  Cantilever result;
  result.stiffness = assembled_stiffness(kind, grid, law)(free, free);
  result.masses.resize(result.stiffness.rows());
  result.tip = Eigen::VectorXd::Zero(result.stiffness.rows());
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::size_t point = free[k] / 2;
    result.masses[k] = masses[point];
    const bool corner = grid.y[point] == 0 || grid.y[point] == kHeight;
    if (grid.x[point] == 0 && free[k] % 2 == 1) result.tip[k] = (corner ? 0.5 : 1.0) / zones_y;
  }
  return result;
}

double tip_deflection(const Cantilever& beam) {
  return beam.tip.dot(beam.stiffness.ldlt().solve(beam.tip));
}

// Timoshenko's tip deflection under a unit force; `young` is E (plane stress) or E/(1 - nu^2).
double beam_deflection(double young) {
  return std::pow(kLength, 3) / (3 * young * kInertia) + kLength / (kShearFactor * kShearModulus * kHeight);
}

// The default zone bends as the beam does, within 1 %.
TEST(StaticBending, DefaultZoneIsWithinOnePercentOfTheBeam) {
  const double deflection =
      tip_deflection(cantilever(ZoneKind::kAssumedStrain, plane_stress(kYoung, kPoisson)));
  EXPECT_NEAR(deflection / beam_deflection(kYoung), 1, 0.01);
}

// How much too stiff n rows of mixed-discretization zones of width a and height b are, in closed form.
// Bending in a zone is the hourglass pattern u = q xi eta; its triangles have exx = +-2 q/a, gamma = +-2 q/b
// and no mean dilation, so that the energy is 1/2 mu ((2 q/a)^2 + (2 q/b)^2) A, against 1/2 E' (2 q/a)^2 A/3
// of the beam. The zones' own bending is 1/n^2 of the section's, the rest is their mean strain, which is
// exact.
double triangles_excess(double a, double b, double rows) {
  return (3 * kShearModulus * (1 + a * a / (b * b)) / kYoung - 1) / (rows * rows);
}

// The mixed-discretization zone is too stiff by what its triangles lock, whatever the zone's size and form.
TEST(StaticBending, MixedDiscretizationIsTooStiffByItsTriangles) {
  struct Size {
    std::uint32_t zones_x, zones_y;
  };
  for (const auto [zones_x, zones_y] : {Size{20, 4}, Size{40, 2}, Size{40, 4}, Size{40, 8}, Size{80, 8}}) {
    const auto beam =
        cantilever(ZoneKind::kMixedDiscretization, plane_stress(kYoung, kPoisson), zones_x, zones_y);
    const double excess = beam_deflection(kYoung) / tip_deflection(beam) - 1;
    RecordProperty("excess_percent_" + std::to_string(zones_x) + "x" + std::to_string(zones_y),
                   std::to_string(100 * excess));
    EXPECT_NEAR(excess, triangles_excess(kLength / zones_x, kHeight / zones_y, zones_y), 0.01)
        << zones_x << " x " << zones_y;
  }
}

// Plane strain replaces E by E/(1 - nu^2) in bending.
TEST(StaticBending, PlaneStrainIsStifferThanPlaneStressByTheTheory) {
  const double stress = tip_deflection(cantilever(ZoneKind::kAssumedStrain, plane_stress(kYoung, kPoisson)));
  const double strain = tip_deflection(cantilever(ZoneKind::kAssumedStrain, plane_strain(kYoung, kPoisson)));
  EXPECT_NEAR(strain / stress, beam_deflection(kYoung / (1 - kPoisson * kPoisson)) / beam_deflection(kYoung),
              1e-3);
}

// Moment and shear at the fixed end are both 0 for some unit state at the free one at a natural frequency of
// Timoshenko's beam: determinant over omega [rad/s]. State (w, phi, M, Q) from the clamped end.
double frequency_determinant(double omega) {
  const double w2 = omega * omega;
  Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
  a(0, 1) = 1;
  a(0, 3) = 1 / (kShearFactor * kShearModulus * kHeight);
  a(1, 2) = 1 / (kYoung * kInertia);
  a(2, 1) = -kDensity * kInertia * w2;
  a(2, 3) = -1;
  a(3, 0) = -kDensity * kHeight * w2;
  constexpr int kSegments = 1000;
  const Eigen::Matrix4d s = a * (kLength / kSegments), one = Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d segment = one + s * (one + s / 2 * (one + s / 3 * (one + s / 4)));
  Eigen::Matrix4d transfer = one;
  for (int i = 0; i < kSegments; ++i) transfer = segment * transfer;
  return transfer.bottomRightCorner<2, 2>().determinant();
}

// The first bending frequency of the grid with lumped masses is that of Timoshenko's beam, within 1 %.
TEST(BendingFrequency, FirstIsWithinOnePercentOfTimoshenkosBeam) {
  const double bernoulli =
      1.8751 * 1.8751 * std::sqrt(kYoung * kInertia / (kDensity * kHeight * std::pow(kLength, 4)));
  double low = 0.9 * bernoulli, high = 1.1 * bernoulli;
  ASSERT_LT(frequency_determinant(low) * frequency_determinant(high), 0);
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (frequency_determinant(low) * frequency_determinant(middle) <= 0 ? high : low) = middle;
  }
  const auto beam = cantilever(ZoneKind::kAssumedStrain, plane_stress(kYoung, kPoisson));
  const Eigen::VectorXd root = beam.masses.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = root.asDiagonal() * beam.stiffness * root.asDiagonal();
  const double first = std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0]);
  EXPECT_NEAR(first / low, 1, 0.01);
  EXPECT_GT(bernoulli, low);  // the reference is corrected for shear and rotation
}

}  // namespace
}  // namespace adit::fdm::test::bending_test
