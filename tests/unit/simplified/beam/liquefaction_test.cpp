// A tube in ground whose pore pressure rises: its springs weaken, and it floats up.
#include <gtest/gtest.h>

#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::liquefaction_test {
namespace {

constexpr double kSoil = 1.661e8, kSlip = 3e6, kHardening = 0.05, kLiquefied = 0.1, kUplift = 2e6;
constexpr double kRise = 10;  // time in which the pressure rises to 1 [s]

Tunnel tube(double slip_force) {
  Tunnel tunnel = immersed_tube(0, 200, 20, kSoil);
  for (SoilStation& station : tunnel.soil) {
    station.liquefied = kLiquefied;
    station.uplift = kUplift;
    for (SoilSpring& spring : station.springs) spring = {kSoil, slip_force, kHardening, 1e6};
  }
  return tunnel;
}

double rising(double t) {
  return std::min(1.0, t / kRise);
}

// The pressure ratio beside a motion of the ground.
GroundMotion with_pressure(GroundMotion motion, std::function<double(double, double)> ratio) {
  return [=](double t, std::span<const double> chainages, GroundState& state) {
    motion(t, chainages, state);
    for (std::size_t i = 0; i < chainages.size(); ++i) state.pressure_ratio[i] = ratio(t, chainages[i]);
  };
}

Results lifted(Tunnel tunnel, double from_time = 0) {
  tunnel.inertia = false;
  for (SoilStation& station : tunnel.soil)
    for (SoilSpring& spring : station.springs) spring.dashpot = 0;
  RunOptions options;
  options.dt = kRise / 400;
  options.steps = 500;
  options.scheme = newmark();
  options.stations = {100};
  return run(tunnel, with_pressure(still(), [=](double t, double) { return rising(from_time + t); }),
             options);
}

// The uplift grows with the ratio while the springs weaken: z = r q/(k (1 − r (1 − liquefied))), also if the
// run begins with a pressure.
TEST(LiquefiedGround, LiftsTheTubeByTheUpliftOnWeakSprings) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double begin : {0.0, 4.0, kRise})
    for (const Record& record : lifted(tube(infinite), begin).histories) {
      const double ratio = rising(begin + record.time);
      EXPECT_NEAR(record.displacement[kVertical][0],
                  ratio * kUplift / (kSoil * (1 - ratio * (1 - kLiquefied))),
                  1e-7 * kUplift / kSoil / kLiquefied);
      EXPECT_EQ(record.pressure_ratio[0], ratio);
    }
}

// The force at which the ground slips falls as its stiffness does.
TEST(LiquefiedGround, SlipsUnderTheShareOfItsForce) {
  const double lift = lifted(tube(kSlip)).histories.back().displacement[kVertical][0];
  EXPECT_NEAR(lift, (kUplift / kLiquefied - (1 - kHardening) * kSlip) / (kHardening * kSoil), 1e-7 * lift);
}

GroundMotion shaking() {
  return moving(
      kLateral, [](double t, double x) { return 0.1 * (1 - std::cos(8 * (t - x / 300))) * (t > x / 300); },
      [](double t, double x) { return 0.8 * std::sin(8 * (t - x / 300)) * (t > x / 300); });
}

// At a constant ratio the tube is that on springs, dashpots and slip forces of the share that is left.
TEST(LiquefiedGround, WeakensStiffnessDashpotsAndSlipForceAlike) {
  constexpr double kRatio = 0.7, kLeft = 1 - kRatio * (1 - kLiquefied);
  Tunnel liquefied = tube(kSlip), weak = tube(kLeft * kSlip);
  for (SoilStation& station : liquefied.soil) station.uplift = 0;
  for (SoilStation& station : weak.soil)
    for (SoilSpring& spring : station.springs) {
      spring.stiffness *= kLeft;
      spring.dashpot *= kLeft;
    }
  for (const Scheme& scheme : {energy_conserving(), newmark(), hht(0.1)}) {
    RunOptions options;
    options.dt = 0.01;
    options.steps = 300;
    options.scheme = scheme;
    options.stations = {50};
    const Results one =
        run(liquefied, with_pressure(shaking(), [](double, double) { return kRatio; }), options);
    const Results other = run(weak, shaking(), options);
    EXPECT_GT(one.energy.slip, 0.01 * one.energy.input);
    EXPECT_EQ(one.energy.weakening, 0);
    for (const auto& energy : {&Energy::dashpots, &Energy::slip, &Energy::soil, &Energy::input})
      EXPECT_NEAR(one.energy.*energy, other.energy.*energy, 1e-6 * other.energy.input);
    for (std::size_t n = 0; n < one.histories.size(); ++n)
      EXPECT_NEAR(one.histories[n].displacement[kLateral][0], other.histories[n].displacement[kLateral][0],
                  1e-8);
  }
}

// While one half of the ground liquefies the balance of energies closes; what weakening loses is a part of
// it.
TEST(LiquefiedGround, EnergyIsConserved) {
  for (const double dt : {0.02, 0.01}) {
    RunOptions options;
    options.dt = dt;
    options.steps = std::lround(8 / dt);
    const auto half = [](double t, double x) { return std::clamp((x - 60) / 80, 0.0, 1.0) * rising(2 * t); };
    const Results results = run(tube(kSlip), with_pressure(shaking(), half), options);
    EXPECT_GT(results.energy.weakening, 1e-3 * results.energy.input);
    EXPECT_GT(results.energy.loads, 0);
    EXPECT_GT(results.energy.slip, 0);
    EXPECT_LE(results.energy_error, 1e-9);
  }
}

// A bent tube on springs that stand still bears what they give; as they weaken, all of their energy but the
// share that is left goes, and nothing comes back: the tube never moves further than where it was pulled to.
TEST(LiquefiedGround, LetsGoWhatItBears) {
  Tunnel tunnel = immersed_tube(0, 200, 20, kSoil);
  for (SoilStation& station : tunnel.soil) station.liquefied = kLiquefied;
  const GroundMotion ground = displaced(kLateral, [](double x) { return 0.1 * std::cos(kPi * x / 50); });
  RunOptions options;
  options.dt = 0.01;
  options.steps = 2000;
  const Results results =
      run(tunnel, with_pressure(ground, [](double t, double) { return rising(t); }), options);
  EXPECT_GT(results.energy.weakening, 0);
  EXPECT_NEAR(results.energy.soil + results.energy.strain + results.energy.kinetic + results.energy.weakening,
              0, 1e-9 * results.energy.weakening);
}

}  // namespace
}  // namespace adit::simplified::beam::liquefaction_test
