// Waves in lattices of contact bonds with spin, against the theory in periodic_lattice.hpp.
#include <gtest/gtest.h>

#include "dem_server/model/calibration.hpp"
#include "tests/verification/particles/periodic_lattice.hpp"

namespace adit::dem::dispersion_test {
namespace {

constexpr double kYoung = 25e9, kDensity = 2500;

ContactBond law_of(double poisson_ratio) {
  return {calibrate(kYoung, poisson_ratio, Plane::kStress), kUnbreakable, kUnbreakable};
}

class LatticeWaves : public testing::TestWithParam<test::LatticeDirection> {};

// The whole curve, from the longest wave to the shortest one and for all three branches: omega to 1e-6 of
// theory, and the motion stays in the mode.
TEST_P(LatticeWaves, FollowTheDispersionCurve) {
  constexpr std::uint32_t kCount = 24;
  const double mass = kDensity * GetParam().cell_area;
  const Assembly lattice = test::periodic(GetParam(), kCount, mass);
  for (const double poisson_ratio : {0.0, 0.2, 0.3}) {
    const ContactBond law = law_of(poisson_ratio);
    for (std::uint32_t m = 1; m <= kCount / 2; ++m) {
      const double phase = 2 * std::numbers::pi * m / kCount;
      const auto [omega_squared, modes] = test::in_theory(GetParam(), law.stiffness, mass, phase);
      for (int branch = 0; branch < 3; ++branch) {
        const auto found = test::swing(law, phase, modes.col(branch), 300, lattice);
        // A square lattice turns like gears, without any frequency.
        const double gears = 1e-12 * omega_squared[2];
        EXPECT_NEAR(found.omega_squared, omega_squared[branch], 2e-6 * omega_squared[branch] + gears)
            << "phase " << phase << ", branch " << branch << ", Poisson's ratio " << poisson_ratio;
        EXPECT_LT(found.astray, 1e-6) << "phase " << phase << ", branch " << branch;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LatticeWaves, testing::ValuesIn(test::kLatticeDirections),
                         [](const auto& info) { return info.param.name; });

// Speeds of long waves, extrapolated over the square of the wavenumber, are the elastic solid's to 1e-6 in
// both directions of the hexagonal lattice: P with lambda + 2 mu, S with mu, of the moduli that it was
// calibrated to.
TEST(LatticeWaves, LongOnesAreTheElasticSolids) {
  for (const auto& direction : {test::kLatticeDirections[0], test::kLatticeDirections[1]})
    for (const double poisson_ratio : {0.0, 0.2, 0.3}) {
      const ContactBond law = law_of(poisson_ratio);
      const double mu = kYoung / 2 / (1 + poisson_ratio),
                   p_modulus = kYoung / (1 - poisson_ratio * poisson_ratio);
      const double speeds[] = {std::sqrt(mu / kDensity), std::sqrt(p_modulus / kDensity)};
      for (int branch = 0; branch < 2; ++branch) {
        const auto speed = [&](std::uint32_t count) {
          const double phase = 2 * std::numbers::pi / count;
          const double mass = kDensity * direction.cell_area;
          const auto [_, modes] = test::in_theory(direction, law.stiffness, mass, phase);
          const Assembly lattice = test::periodic(direction, count, mass);
          const auto found = test::swing(law, phase, modes.col(branch), 2000, lattice);
          return std::sqrt(found.omega_squared) / (phase / direction.advance());
        };
        const double found = (4 * speed(192) - speed(96)) / 3;
        EXPECT_NEAR(found / speeds[branch], 1, 1e-6) << direction.name << ", branch " << branch;
      }
    }
}

// At the longest wave the rotation branch is 24 ks / m: three pairs of bonds resist the spins that all turn
// alike.
TEST(LatticeWaves, RotationStartsAtItsOwnFrequency) {
  const ContactBond law = law_of(0.2);
  const auto& direction = test::kLatticeDirections[0];
  const double mass = kDensity * direction.cell_area;
  const auto found = test::swing(law, 0, {0, 0, 1}, 300, test::periodic(direction, 8, mass));
  EXPECT_NEAR(std::sqrt(found.omega_squared * mass / (24 * law.stiffness.shear)), 1, 1e-6);
}

}  // namespace
}  // namespace adit::dem::dispersion_test
