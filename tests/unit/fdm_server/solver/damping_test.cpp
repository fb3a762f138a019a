// Requirements on damping: standing waves decay at the rate that theory gives.
#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::damping_test {
namespace {

using std::numbers::pi;

const PlaneLaw kLaw = plane_strain(2e8, 0.25);
constexpr double kHeight = 10;  // [m]

double frequency(int mode) {
  return mode * kShearVelocity / (2 * kHeight);
}

// Energy of the standing shear wave of a layer held below and above, v = sin(mode pi y/H), over that at its
// start, after some whole periods.
double energy_left(ZoneKind kind, const DampingLaw& law, int mode, int periods) {
  const std::uint32_t zones = 80;
  const Grid grid = make_grid({0, 1, 0, kHeight, 1, zones});
  std::vector<std::uint32_t> all(grid.x.size()), ends;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    all[i] = i;
    if (grid.y[i] == 0 || grid.y[i] == kHeight) ends.push_back(i);
  }
  const auto always = [](double) { return 1.0; };
  Continuum continuum(ZoneSet(kind, grid, kLaw, ones(grid)), lumped_masses(grid, ones(grid), kGroundDensity),
                      {}, {{all, Axis::kY, 0.0, always}, {ends, Axis::kX, 0.0, always}});
  continuum.set_damping(law);
  const double longest = critical_step(law, critical_step(kind, grid, kLaw, kGroundDensity));
  const double duration = periods / frequency(mode);
  const auto steps = static_cast<std::uint64_t>(std::ceil(duration / (0.5 * longest)));
  const double dt = duration / static_cast<double>(steps);
  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    continuum.vx()[i] = std::sin(mode * pi * grid.y[i] / kHeight);
  for (const auto i : ends) continuum.vx()[i] = 0;
  Energies first{}, last{};
  continuum.step({1, dt}, &first);
  for (std::uint64_t n = 2; n <= steps + 1; ++n) continuum.step({n, dt}, &last);
  EXPECT_NEAR(last.kinetic + last.strain + last.dissipated, first.kinetic + first.strain + first.dissipated,
              1e-10 * first.kinetic);
  return (last.kinetic + last.strain) / (first.kinetic + first.strain);
}

// Rayleigh damping: the stated ratio at both frequencies, the known one between and above; within 0.5 % of
// the rate.
TEST(Damping, StandingWavesDecayAtRayleighsRate) {
  const double ratio = 0.03;
  const DampingLaw law = rayleigh(ratio, frequency(1), frequency(4));
  for (const ZoneKind kind : kKinds)
    for (const int mode : {1, 2, 4, 6}) {
      const double w = 2 * pi * frequency(mode), here = (law.alpha / w + law.elements[0].viscosity() * w) / 2;
      if (mode == 1 || mode == 4) {
        EXPECT_NEAR(here, ratio, 1e-12);
      }
      if (mode <= 4) {
        EXPECT_NEAR(damping_ratio(law, frequency(mode)), here, ratio * ratio * here) << "mode " << mode;
      }
      const int periods = 8;
      const double decay = -std::log(energy_left(kind, law, mode, periods)) / (2 * 2 * pi * periods);
      EXPECT_NEAR(decay, here, 0.005 * here) << "mode " << mode;
    }
}

// The ratio L/2(1 + S) of Maxwell's elements from one frequency to the other is the stated one within 5 %,
// bands of up to 100 to 1, and every spring pushes back.
TEST(MaxwellDamping, RatioIsTheSameOverTheBand) {
  for (const double ratio : {0.001, 0.01, 0.05})
    for (const double band : {1.0, 3.0, 10.0, 30.0, 100.0}) {
      const DampingLaw law = maxwell(ratio, 0.5, 0.5 * band);
      EXPECT_EQ(law.count(), kMostElements);
      for (const auto& element : law.elements) EXPECT_GT(element.spring, 0);
      for (double f = 0.5; f <= 0.5 * band * (1 + 1e-9); f *= 1.05) {
        EXPECT_NEAR(damping_ratio(law, f), ratio, 0.05 * ratio) << band << " " << f;
      }
    }
  const DampingLaw one = maxwell(0.01, 1, 10);
  EXPECT_NEAR(stiffening(one, 1), 1.025, 5e-4);  // as damping_law.hpp and boundaries.proto tell
  EXPECT_NEAR(stiffening(one, 10), 1.056, 5e-4);
  EXPECT_NEAR(stiffening(maxwell(0.05, 1, 10), 1), 1.13, 5e-3);
  EXPECT_NEAR(stiffening(maxwell(0.05, 1, 10), 10), 1.31, 5e-3);
}

// Standing waves decay at the stated ratio of their stiffened frequency, within 5 %, and as the elements' sum
// of moduli says, within 1 %: s with M s^2 + K (1 + sum s_e tau_e s/(1 + tau_e s)) = 0.
TEST(MaxwellDamping, StandingWavesDecayAtTheStatedRatio) {
  const double ratio = 0.03;
  const DampingLaw law = maxwell(ratio, frequency(1), frequency(4));
  for (const ZoneKind kind : kKinds)
    for (const int mode : {1, 2, 4}) {
      const double w = 2 * pi * frequency(mode);
      std::complex<double> s(-ratio * w, w);
      for (int k = 0; k < 50; ++k) {
        std::complex<double> modulus = 1;
        for (const auto& [spring, relaxation] : law.elements)
          modulus += spring * relaxation * s / (1.0 + relaxation * s);
        s = std::complex<double>(0, w) * std::sqrt(modulus);
      }
      const int periods = 24;  // the energy of the elements' springs, which is not counted, swings in each
      const double decay = -std::log(energy_left(kind, law, mode, periods)) / (2 * 2 * pi * periods);
      EXPECT_NEAR(decay, -s.real() / w, 0.01 * decay) << "mode " << mode;
      EXPECT_NEAR(-s.real() / std::abs(s), ratio, 0.05 * ratio) << "mode " << mode;
    }
}

// Either part alone, too.
TEST(Damping, MassAndStiffnessDampAlone) {
  for (const DampingLaw& law : {rayleigh(3, 0), rayleigh(0, 5e-4)})
    for (const int mode : {1, 3}) {
      const double w = 2 * pi * frequency(mode), here = (law.alpha / w + law.elements[0].viscosity() * w) / 2;
      const double decay = -std::log(energy_left(kKinds[0], law, mode, 8)) / (4 * pi * 8);
      EXPECT_NEAR(decay, here, 0.005 * here) << "mode " << mode;
    }
}

// Damping of the masses alone: ground that falls under its weight ends at the speed g/alpha, at which drag
// and weight are equal, however long the step is.
TEST(Damping, DragOfTheMassesEndsAtTheTerminalVelocity) {
  const double alpha = 50, gravity = 10, dt = 2e-3;
  const Grid grid = make_grid({0, 1, 0, 1, 1, 1});
  const auto masses = lumped_masses(grid, ones(grid), kGroundDensity);
  Load weight{{0, 1, 2, 3}, {0, 0, 0, 0}, {}, {}};
  for (const double mass : masses) weight.fy.push_back(-gravity * mass);
  Continuum continuum(ZoneSet(kKinds[0], grid, kLaw, ones(grid)), masses, {weight}, {});
  continuum.set_damping(rayleigh(alpha, 0));
  for (std::uint64_t n = 0; n <= 500; ++n) continuum.step({n, dt});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(continuum.vy()[i], -gravity / alpha, 1e-9);
}

// Local damping: half a cycle leaves (1 - a)/(1 + a) of the energy, whatever the frequency, because the
// stiffness is 1 - a on the way to rest and 1 + a on the way from it.
TEST(Damping, LocalDampingIsTheSameAtEveryFrequency) {
  const double a = 0.05;
  for (const int mode : {1, 3}) {
    const double decay = -std::log(energy_left(kKinds[0], {.local = a}, mode, 4));
    const double expected = -2 * 4 * std::log((1 - a) / (1 + a));
    EXPECT_NEAR(decay, expected, 0.005 * expected) << "mode " << mode;
  }
}

// Stiffness-proportional damping shortens the critical step as stated, by its dashpot where it is weak and by
// its spring where it is strong: just below it the roughest motion dies, just above it grows.
TEST(Damping, CriticalStepIsThatOfTheViscousScheme) {
  const Grid grid = make_grid({0, 4, 0, 3, 4, 3}), single = make_grid({0, 1, 0, 1, 1, 1});
  const double undamped = critical_step(kKinds[1], grid, kLaw, kGroundDensity);
  for (const DampingLaw& law : {rayleigh(0, 1e-3), rayleigh(0, 0.1), maxwell(0.05, 1, 10)}) {
    double springs = 0, viscosity = 0;
    for (const auto& element : law.elements) {
      springs += element.spring;
      viscosity += element.viscosity();
    }
    const double y = viscosity / undamped;
    EXPECT_NEAR(critical_step(law, undamped),
                undamped * std::max(std::sqrt(1 + y * y) - y, 1 / std::sqrt(1 + springs)), 1e-12 * undamped);
    EXPECT_LT(critical_step(law, undamped), 0.83 * undamped);
    const auto grows = [&](const Grid& one, double share) {
      Continuum continuum(ZoneSet(kKinds[1], one, kLaw, ones(one)),
                          lumped_masses(one, ones(one), kGroundDensity), {}, {});
      continuum.set_damping(law);
      const double dt = share * critical_step(law, critical_step(kKinds[1], one, kLaw, kGroundDensity));
      continuum.step({0, dt});
      for (std::size_t i = 0; i < one.x.size(); ++i) {
        continuum.vx()[i] = std::sin(7.0 * static_cast<double>(i));
        continuum.vy()[i] = std::cos(5.0 * static_cast<double>(i));
      }
      Energies e{};
      for (std::uint64_t n = 1; n <= 3000; ++n) continuum.step({n, dt}, &e);
      return !(e.strain < 1e6);
    };
    EXPECT_FALSE(grows(grid, 0.999)) << springs;
    EXPECT_FALSE(grows(single, 0.999)) << springs;
    EXPECT_TRUE(grows(single, 1.01)) << springs;  // of one zone the bound is exact
  }
}

}  // namespace
}  // namespace adit::fdm::test::damping_test
