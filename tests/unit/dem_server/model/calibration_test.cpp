#include "dem_server/model/calibration.hpp"

#include <gtest/gtest.h>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::calibration_test {
namespace {

struct Stress {
  double xx, yy, xy;
};

// Mean stress of the cell around an interior particle under the strain (xx, yy, xy), from the forces of its
// bonds: sum of force (x) half branch vector over the cell's area.
Stress stress_under(double exx, double eyy, double exy, const ContactBond& law, double radius) {
  Assembly a = test::assemble(test::rows_of(5, 6, radius), 1.0);
  Particles& p = a.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = p.ux[i] = exx * p.x[i] + exy * p.y[i];
    p.vy[i] = p.uy[i] = exy * p.x[i] + eyy * p.y[i];
  }
  test::compute(law, 1.0, a);
  const std::uint32_t centre = 6 + 5 + 2;
  Stress s{0, 0, 0};
  const double area = 2 * std::numbers::sqrt3 * radius * radius;
  for (std::size_t k = 0; k < a.bonds.size(); ++k) {
    const std::uint32_t i = a.bonds.first[k], j = a.bonds.second[k];
    if (i != centre && j != centre) continue;
    const double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], length = std::hypot(dx, dy);
    const double fn = a.bonds.normal_force[k], fs = a.bonds.shear_force[k];
    const double fx = (fn * dx - fs * dy) / length, fy = (fn * dy + fs * dx) / length;
    s.xx += fx * dx / 2 / area;
    s.yy += fy * dy / 2 / area;
    s.xy += (fx * dy + fy * dx) / 4 / area;
  }
  return s;
}

struct Case {
  double nu;
  Plane plane;
};
class Moduli : public testing::TestWithParam<Case> {};

// The lattice under uniform strain has the stresses of the solid that it was calibrated to.
TEST_P(Moduli, UniformStrainGivesTheSolidsStress) {
  const auto [nu, plane] = GetParam();
  const double e = 25e9, radius = 0.07, strain = 1e-9;
  const ContactBond law{calibrate(e, nu, plane), kUnbreakable, kUnbreakable};
  const double mu = e / (2 * (1 + nu));
  const double lambda = plane == Plane::kStress ? e * nu / (1 - nu * nu) : e * nu / ((1 + nu) * (1 - 2 * nu));
  const double tolerance = 1e-6 * e;
  const Stress pull = stress_under(strain, 0, 0, law, radius);
  EXPECT_NEAR(pull.xx / strain, lambda + 2 * mu, tolerance);
  EXPECT_NEAR(pull.yy / strain, lambda, tolerance);
  EXPECT_NEAR(pull.xy / strain, 0, tolerance);
  const Stress lift = stress_under(0, strain, 0, law, radius);
  EXPECT_NEAR(lift.yy / strain, lambda + 2 * mu, tolerance);
  EXPECT_NEAR(lift.xx / strain, lambda, tolerance);
  EXPECT_NEAR(stress_under(0, 0, strain, law, radius).xy / strain, 2 * mu, tolerance);
}

INSTANTIATE_TEST_SUITE_P(All, Moduli,
                         testing::Values(Case{0.0, Plane::kStress}, Case{0.2, Plane::kStress},
                                         Case{1.0 / 3, Plane::kStress}, Case{0.2, Plane::kStrain},
                                         Case{0.25, Plane::kStrain}));

// The shear stiffness vanishes at the largest Poisson ratio, below which it is positive.
TEST(Calibration, ShearStiffnessVanishesAtTheLimit) {
  for (const Plane plane : {Plane::kStress, Plane::kStrain}) {
    const BondStiffness k = calibrate(1.0, largest_poisson_ratio(plane), plane);
    EXPECT_NEAR(k.shear / k.normal, 0, 1e-15);
    EXPECT_GT(calibrate(1.0, 0.9 * largest_poisson_ratio(plane), plane).shear, 0);
  }
}

// The cantilever's stiffnesses are those of the project's reference computation (to its printed digits).
TEST(Calibration, CantileverStiffnesses) {
  const BondStiffness k = calibrate(25e9, 0.2, Plane::kStress);
  EXPECT_NEAR(k.normal, 1.81e10, 0.01e10);
  EXPECT_NEAR(k.shear, 6.0e9, 0.05e9);
  EXPECT_DOUBLE_EQ(k.shear / k.normal, (1 - 3 * 0.2) / (1 + 0.2));
}

// The particles' masses add up to that of the solid: the cells fill the box.
TEST(Calibration, CellsCarryTheWholeMass) {
  const double radius = 0.3;
  EXPECT_DOUBLE_EQ(cell_mass(2000, radius), 2000 * (2 * radius) * (std::numbers::sqrt3 * radius));
}

class Waves : public testing::TestWithParam<double> {};

// Plane P and S waves along the rows: the kernel's force on an interior particle is -omega^2 M z with the
// lattice's dispersion relation (phi = k R; spins take part in the S wave).
TEST_P(Waves, FollowTheDispersionRelation) {
  const double phi = GetParam(), radius = 0.5, mass = 3.0, inertia = mass * radius * radius / 2,
               amplitude = 1e-9;
  const ContactBond law{{4.0, 1.5}, kUnbreakable, kUnbreakable};
  const double kn = law.stiffness.normal, ks = law.stiffness.shear;
  const Model packing = test::rows_of(3, 12, radius);
  const std::uint32_t centre = 12 + 5;

  Assembly p_wave = test::assemble(packing, mass);
  for (std::size_t i = 0; i < p_wave.particles.size(); ++i)
    p_wave.particles.vx[i] = p_wave.particles.ux[i] =
        amplitude * std::cos(phi * p_wave.particles.x[i] / radius);
  test::compute(law, 1.0, p_wave);
  const double p_stiffness = 2 * kn * (1 - std::cos(2 * phi)) + (kn + 3 * ks) * (1 - std::cos(phi));
  const double cosine = std::cos(phi * p_wave.particles.x[centre] / radius);
  ASSERT_GT(std::abs(cosine), 0.01);
  EXPECT_NEAR(p_wave.particles.fx[centre] / (-amplitude * cosine), p_stiffness, 1e-6 * kn);

  // S: u_y = U cos kx, spin angle = -T sin kx.
  const double s1 = std::sin(phi), c1 = std::cos(phi), s2 = std::sin(phi / 2), c2 = std::cos(phi / 2);
  Eigen::Matrix2d k, m;
  k << 4 * ks * s1 * s1 + (2 * ks + 6 * kn) * s2 * s2, -4 * ks * radius * (s1 * c1 + s2 * c2),
      -4 * ks * radius * (s1 * c1 + s2 * c2), ks * radius * radius * (4 * c1 * c1 + 8 * c2 * c2);
  m << mass, 0, 0, inertia;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(k, m);
  for (int mode = 0; mode < 2; ++mode) {
    const double omega2 = modes.eigenvalues()(mode);
    const double u = amplitude * modes.eigenvectors()(0, mode), t = amplitude * modes.eigenvectors()(1, mode);
    Assembly a = test::assemble(packing, mass);
    Particles& p = a.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vy[i] = p.uy[i] = u * std::cos(phi * p.x[i] / radius);
      p.spin[i] = -t * std::sin(phi * p.x[i] / radius);
    }
    test::compute(law, 1.0, a);
    const double tolerance = 1e-6 * kn * amplitude;
    EXPECT_NEAR(p.fy[centre], -omega2 * mass * p.uy[centre], tolerance);
    EXPECT_NEAR(p.moment[centre], -omega2 * inertia * p.spin[centre], tolerance);
  }
  if (phi < 0.05) {  // long waves run at the solid's speeds
    const double lambda_2mu = std::numbers::sqrt3 / 4 * (3 * kn + ks),
                 mu = std::numbers::sqrt3 / 4 * (kn + ks);
    const double density = mass / cell_mass(1.0, radius), wave_number = phi / radius;
    EXPECT_NEAR(std::sqrt(p_stiffness / mass) / wave_number, std::sqrt(lambda_2mu / density), 1e-3);
    EXPECT_NEAR(std::sqrt(modes.eigenvalues()(0)) / wave_number, std::sqrt(mu / density), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(WaveNumbers, Waves, testing::Values(0.02, 0.3, 0.8, 1.4));

}  // namespace
}  // namespace adit::dem::calibration_test
