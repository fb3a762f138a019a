// Requirements on linings and bolts in motion: energy, halves of a step, yield.
#include <gtest/gtest.h>

#include <algorithm>

#include "fdm_server/participant/critical_element.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::ledger_test {
namespace {

const PlaneLaw kLaw = plane_strain(2e9, 0.3);
constexpr Block kGround{0, 8, 0, 4, 8, 4};
constexpr double kMoment = 2e4, kThrust = 3e4;

// Ground with a lining through it that has joints, and a bolt; both yield. Steps are 0.8 of the critical one,
// of the ground alone where `long_steps`.
struct LinedGround {
  bool long_steps = false;
  Grid grid = make_grid(kGround);
  Structures structures{};
  double dt = 0;

  Continuum continuum() {
    const Path roof{{19, 20, 21, 22, 23, 24, 25}, false};
    const std::vector<LiningJoint> joints{{2, 1e8, kMoment}, {4, 0, 0}};
    add_lining({"roof", roof, wall(0.3), joints, true, false}, grid, structures);
    const BarSection steel{210e9 * 5e-4, kThrust, 7850 * 5e-4};
    for (std::uint32_t p = 22; p <= 31; p += 9) {
      const std::uint32_t q = p + 9;
      structures.add_bar(Bar({p, q}, chord(grid.x[p], grid.y[p], grid.x[q], grid.y[q]), steel));
    }
    auto masses = lumped_masses(grid, ones(grid), 2000);
    structures.add_masses(masses);
    dt = 0.8 * critical_step(ZoneKind::kAssumedStrain, grid, kLaw, 2000);
    if (!long_steps) dt = std::min(dt, 0.8 * structures.critical_step());
    const std::vector<std::uint32_t> base{0, 1, 2, 3, 4, 5, 6, 7, 8}, pushed{22, 44};
    const std::vector<double> fx{4e5, 0}, fy{-8e5, 3e5};
    const auto shake = [](double t) { return std::cos(150 * t); };
    return {ZoneSet(ZoneKind::kAssumedStrain, grid, kLaw, ones(grid)),
            masses,
            {Load{pushed, fx, fy, constant}},
            {PrescribedMotion{base, Axis::kX, 0.5, shake}, PrescribedMotion{base, Axis::kY, 0.2, shake}},
            1,
            structures};
  }
};

double balance(const Energies& e) {
  return e.kinetic + e.strain + e.dissipated - e.external_work;
}

// Steps `first` to 20000: the last energies, the largest one, and how far the balance drifted from that
// before.
struct Ledger {
  Energies last{};
  double peak = 0, drift = 0;

  Ledger(Continuum& continuum, double dt, std::uint64_t first, const Energies& before) {
    for (std::uint64_t n = first; n <= 20000; ++n) {
      continuum.step({n, dt}, &last);
      peak = std::max({peak, last.kinetic, last.strain});
      drift = std::max(drift, std::abs(balance(last) - balance(before)));
    }
  }
};

// Kinetic, strain and dissipated energy less work keep their first value, while joints and bolts yield.
TEST(LiningLedger, ClosesToRounding) {
  for (const bool long_steps : {false, true}) {
    LinedGround ground{long_steps};
    Continuum continuum = ground.continuum();
    EXPECT_EQ(continuum.longer_than_structures(ground.dt), long_steps);
    Energies first{};
    continuum.step({0, ground.dt}, &first);
    const Ledger ledger(continuum, ground.dt, 1, first);
    EXPECT_LE(ledger.drift, 1e-10 * ledger.peak);
    EXPECT_GE(ledger.last.dissipated, 1e-3 * ledger.peak);
  }
}

// Damping is that of the ground: the step that zones with damping allow, and beams without where they do not
// move by mean acceleration, is stable from the roughest start, and the ledger closes. With Rayleigh damping
// of their own the beams would need half of their step.
TEST(LiningLedger, DampingOfTheGroundLeavesTheLiningsStep) {
  for (const bool known_early : {true, false})
    for (const DampingLaw& law : {rayleigh(1, 3e-4), maxwell(0.05, 5, 50)}) {
      LinedGround ground;
      Continuum continuum = ground.continuum();
      const Ground one{{Material{2000, 2e9, 0.3}}, std::vector<std::uint32_t>(ground.grid.zones.size(), 0)};
      const CriticalElement critical =
          critical_element(ZoneKind::kAssumedStrain, ground.grid, one, Supports{ground.structures},
                           {std::vector<bool>(ground.grid.x.size(), known_early), {}}, law, 0);
      const double zones =
                       critical_step(law, critical_step(ZoneKind::kAssumedStrain, ground.grid, kLaw, 2000)),
                   beams = ground.structures.critical_step();
      EXPECT_EQ(critical.step, known_early ? std::min(beams, zones) : zones);
      continuum.set_damping(law);
      const double dt = 0.999 * critical.step;
      EXPECT_EQ(continuum.longer_than_structures(dt), !known_early);
      continuum.step({0, dt});
      for (std::size_t i = 9; i < ground.grid.x.size(); ++i) {
        continuum.vx()[i] = std::sin(7.0 * static_cast<double>(i * i));
        continuum.vy()[i] = std::cos(5.0 * static_cast<double>(i * i));
      }
      double start = 0;  // the kinetic energy that was given
      for (std::size_t i = 0; i < ground.grid.x.size(); ++i)
        start +=
            continuum.masses()[i] * (std::pow(continuum.vx()[i], 2) + std::pow(continuum.vy()[i], 2)) / 2;
      Energies first{};
      continuum.step({1, dt}, &first);
      const Ledger ledger(continuum, dt, 2, first);
      EXPECT_LE(ledger.peak, 10 * start);
      EXPECT_LE(ledger.drift, 1e-10 * ledger.peak);
    }
}

// Nothing that yields carries more than it may.
TEST(LiningLedger, YieldIsNotExceeded) {
  LinedGround ground;
  Continuum continuum = ground.continuum();
  double thrust = 0;
  for (std::uint64_t n = 0; n <= 5000; ++n) {
    continuum.step({n, ground.dt});
    for (const Bar& bar : continuum.structures().bars()) thrust = std::max(thrust, std::abs(bar.thrust()));
  }
  EXPECT_EQ(thrust, kThrust);
}

// The two halves of a step give what the whole step gives, to the bit.
TEST(LiningLedger, HalvesOfAStepAreTheWhole) {
  LinedGround whole, split;
  Continuum a = whole.continuum(), b = split.continuum();
  const std::vector<std::uint32_t> interface { 20, 21, 22, 30, 31 };
  a.set_interface(interface);
  b.set_interface(interface);
  for (std::uint64_t n = 0; n <= 2000; ++n) {
    a.step({n, whole.dt});
    b.step_interface({n, split.dt});
    b.step_interior({n, split.dt});
  }
  EXPECT_TRUE(std::ranges::equal(a.vx(), b.vx()) && std::ranges::equal(a.vy(), b.vy()));
  EXPECT_TRUE(std::ranges::equal(a.structures().rotations(), b.structures().rotations()));
  EXPECT_NE(a.structures().rotations()[1], 0);
  EXPECT_EQ(a.structures().rotations()[0], 0);  // held
}

// A free lining under no forces keeps its linear and angular momentum.
TEST(LiningLedger, FreeRingKeepsItsMomentum) {
  const Frame frame(circle(3, 24), true, wall(0.3), {{5, 1e7, 1e4}});
  Continuum continuum = frame.continuum({});
  const double dt = 0.9 * frame.structures.critical_step();
  continuum.step({0, dt});
  for (std::size_t i = 0; i < 24; ++i) {
    continuum.vx()[i] = std::sin(1.7 * static_cast<double>(i * i));
    continuum.vy()[i] = std::cos(2.3 * static_cast<double>(i * i));
  }
  const auto masses = frame.masses();
  const auto momentum = [&] {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < 24; ++i) {
      sum[0] += masses[i] * continuum.vx()[i];
      sum[1] += masses[i] * continuum.vy()[i];
    }
    return sum;
  };
  const auto before = momentum();
  for (std::uint64_t n = 1; n <= 5000; ++n) continuum.step({n, dt});
  const auto after = momentum();
  const double scale = 24 * masses[0];
  EXPECT_NEAR(after[0], before[0], 1e-11 * scale);
  EXPECT_NEAR(after[1], before[1], 1e-11 * scale);
}

}  // namespace
}  // namespace adit::fdm::test::ledger_test
