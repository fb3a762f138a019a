// Rigid motions, momentum and energy of free lattices.
#include <gtest/gtest.h>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::conservation_test {
namespace {

const ContactBond kLaw{{7.0, 3.0}, kUnbreakable, kUnbreakable};

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// A rigid translation, however far and fast, gives no force.
TEST(RigidMotion, TranslationGivesNoForce) {
  Assembly a = test::assemble(test::rows_of(5, 8), 2.0);
  Particles& p = a.particles;
  for (auto* values : {&p.ux, &p.vx}) std::fill(values->begin(), values->end(), 12.5);
  for (auto* values : {&p.uy, &p.vy}) std::fill(values->begin(), values->end(), -3.25);
  test::compute(kLaw, 0.1, a);
  EXPECT_EQ(largest(a.bonds.normal_force), 0);
  EXPECT_LT(largest(a.bonds.shear_force), 1e-15);
}

// A rigid rotation by any angle, with the spins equal to the rate of rotation, gives no force.
TEST(RigidMotion, RotationGivesNoForce) {
  for (const double angle : {0.1, 1.0, 3.0}) {
    Assembly a = test::assemble(test::rows_of(5, 8), 2.0);
    Particles& p = a.particles;
    const double rate = 2.0, c = std::cos(angle), s = std::sin(angle);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double x = c * p.x[i] - s * p.y[i], y = s * p.x[i] + c * p.y[i];
      p.ux[i] = x - p.x[i];
      p.uy[i] = y - p.y[i];
      p.vx[i] = -rate * y;
      p.vy[i] = rate * x;
      p.spin[i] = rate;
    }
    test::compute(kLaw, 0.1, a);
    EXPECT_LT(largest(a.bonds.normal_force), 1e-13);
    EXPECT_LT(largest(a.bonds.shear_force), 1e-13);
  }
}

struct Momenta {
  double x = 0, y = 0, angular = 0, scale = 0;
};

Momenta momenta(const Particles& p) {
  Momenta m;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] + p.ux[i], y = p.y[i] + p.uy[i];
    m.x += p.mass[i] * p.vx[i];
    m.y += p.mass[i] * p.vy[i];
    m.angular += p.mass[i] * (x * p.vy[i] - y * p.vx[i]) + p.inertia[i] * p.spin[i];
    m.scale += p.mass[i] * std::hypot(p.vx[i], p.vy[i]) * std::hypot(x, y);
  }
  return m;
}

// A free, weighted lattice in violent motion, breaking in both modes.
struct Violent {
  Model packing = test::rows_of(6, 9);
  Assembly a;
  ContactBond law{{7.0, 3.0}, 0.55, 0.45};
  double dt;
  Violent() {
    std::vector<double> centres(packing.discs.x.size(), 1.0), midpoints(packing.bonds.size());
    test::fill_randomly(midpoints, 0.4, 9);
    for (double& weight : midpoints) weight += 0.5;
    a = test::assemble(packing, 2.0, {centres, midpoints, 1e-3});
    test::fill_randomly(a.particles.vx, 0.2, 1);
    test::fill_randomly(a.particles.vy, 0.2, 2);
    test::fill_randomly(a.particles.spin, 0.4, 3);
    dt = 0.1 * critical_step(a, law.stiffness);
  }
};

// Momentum and angular momentum of a free lattice stay to 1e-12 over 2000 steps, bonds breaking or not.
TEST(Conservation, MomentaStay) {
  for (const bool breakable : {false, true}) {
    Violent v;
    if (!breakable) v.law = kLaw;
    const Momenta start = momenta(v.a.particles);
    test::Ledger ledger;
    for (int n = 1; n <= 2000; ++n) test::step(v.law, v.dt, false, v.a, ledger);
    const Momenta end = momenta(v.a.particles);
    EXPECT_LT(std::abs(end.x - start.x), 1e-12 * start.scale);
    EXPECT_LT(std::abs(end.y - start.y), 1e-12 * start.scale);
    EXPECT_LT(std::abs(end.angular - start.angular), 1e-12 * start.scale);
    EXPECT_EQ(ledger.released > 0, breakable);
  }
}

// Drift of the total energy over `steps` steps of free vibration with velocities of the given size.
double drift(double amplitude, double dt_factor, int steps) {
  Assembly a = test::assemble(test::rows_of(6, 9), 2.0);
  test::fill_randomly(a.particles.vx, amplitude, 1);
  test::fill_randomly(a.particles.vy, amplitude, 2);
  test::fill_randomly(a.particles.spin, amplitude, 3);
  const double dt = dt_factor * critical_step(a, kLaw.stiffness);
  test::Ledger ledger;
  test::step(kLaw, dt, true, a, ledger);
  const double start = ledger.total();
  double worst = 0;
  for (int n = 1; n <= steps; ++n) {
    test::step(kLaw, dt, false, a, ledger);
    worst = std::max(worst, std::abs(ledger.total() - start));
  }
  return worst / start;
}

// In the linear range the leap-frog energy of free vibration is kept: what drifts is the geometric
// nonlinearity, which shrinks with the amplitude.
TEST(Conservation, EnergyOfSmallFreeVibrationsStays) {
  EXPECT_LT(drift(1e-9, 0.5, 2000), 1e-7);
  EXPECT_LT(drift(1e-10, 0.5, 2000), 1e-8);
}

// The ledger closes over breaking: kinetic, strain and released energy add up to the start, and the rest
// shrinks with the step at least in proportion to it.
TEST(Conservation, EnergyLedgerClosesOverBreaking) {
  double worst[2];
  for (const int halving : {0, 1}) {
    Violent v;
    v.dt /= 4 << halving;
    test::Ledger ledger;
    test::step(v.law, v.dt, true, v.a, ledger);
    const double start = ledger.total();
    worst[halving] = 0;
    for (int n = 1; n <= 800 << halving; ++n) {
      test::step(v.law, v.dt, false, v.a, ledger);
      worst[halving] = std::max(worst[halving], std::abs(ledger.total() - start) / start);
    }
    EXPECT_GT(ledger.released, 0.1 * start);
  }
  EXPECT_LT(worst[0], 1e-2);
  EXPECT_LT(worst[1], 0.6 * worst[0]);
}

// A single bond that stretches until it breaks gives the released energy to rounding: what the particles
// lost.
TEST(Conservation, ReleasedEnergyOfOneBondIsExact) {
  Assembly a = test::pair_of_particles();
  a.particles.vx = {-1.0, 1.0};
  const ContactBond law{{7.0, 3.0}, 1.0, kUnbreakable};
  test::Ledger ledger;
  test::step(law, 0.01, true, a, ledger);
  const double start = ledger.total();
  for (int n = 0; n < 30; ++n) test::step(law, 0.01, false, a, ledger);
  ASSERT_EQ(a.bonds.state[0], BondState::kTensileCrack);
  EXPECT_NEAR(ledger.released, 1.0 / (2 * 7.0), 0.02);
  EXPECT_EQ(ledger.strain, 0);
  EXPECT_NEAR(ledger.total(), start, 1e-13);
}

}  // namespace
}  // namespace adit::dem::conservation_test
