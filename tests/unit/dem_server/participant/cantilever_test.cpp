// The cantilever by particles alone against independently computed figures (project's physics notes, section
// 2).
#include <gtest/gtest.h>

#include <vector>

#include "dem_server/model/calibration.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"

namespace adit::dem::cantilever_test {
namespace {

struct Outcome {
  std::vector<double> max_force;  // each step [N]
  double dt = 0, largest_tip = 0, peak = 0, peak_time = 0;
  double energy_drift = 0;  // largest imbalance over the largest energy
  std::vector<wire::Crack> cracks;
  double force_at(double time) const {
    return max_force.at(static_cast<std::size_t>(std::lround(time / dt)));
  }
};

Outcome run_cantilever(double tensile_strength, double duration) {
  auto scene = test::cantilever_scene();
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(tensile_strength);
  test::InProcessRun run(scene);
  const double mass = cell_mass(2500, test::kCantileverRadius);
  run.dt = 0.2 * std::sqrt(mass / calibrate(25e9, 0.2, Plane::kStress).normal);
  Outcome out;
  out.dt = run.dt;
  double imbalance = 0, most = 0;
  for (double step = 0; step * run.dt <= duration; ++step) {
    const auto& predicted = run.advance();
    out.max_force.push_back(predicted.strongest(0).force());
    if (predicted.strongest(0).force() > out.peak) {
      out.peak = predicted.strongest(0).force();
      out.peak_time = step * run.dt;
    }
    out.largest_tip = std::max(out.largest_tip, std::abs(predicted.histories(0)));
    for (const auto& crack : predicted.cracks()) out.cracks.push_back(crack);
    const auto& e = predicted.energies();
    imbalance = std::max(imbalance, std::abs(e.kinetic() + e.strain() + e.released() - e.external_work()));
    most = std::max(most, e.kinetic() + e.strain());
  }
  out.energy_drift = imbalance / most;
  return out;
}

void expect_within(double value, double reference, double share, const std::string& what) {
  EXPECT_NEAR(value, reference, share * reference) << what;
}

// The largest bond force at the paper's instants, its peak and the tip's deflection over 45 ms (as long as
// the reference ran): within 0.5 % of the reference; the energy ledger closes to 1e-5.
TEST(Cantilever, ElasticForcesAreTheReferences) {
  const Outcome out = run_cantilever(std::numeric_limits<double>::infinity(), 0.045);
  const std::pair<double, double> reference[] = {{0.020, 3814e3},  {0.024, 6379e3},  {0.028, 7103e3},
                                                 {0.030, 10628e3}, {0.032, 13033e3}, {0.040, 5467e3}};
  for (const auto& [time, force] : reference)
    expect_within(out.force_at(time), force, 0.005, std::to_string(time) + " s");
  expect_within(out.peak, 13146e3, 0.005, "peak");
  EXPECT_NEAR(out.peak_time, 0.0325, 1e-4);
  expect_within(out.largest_tip, 0.1779, 0.005, "tip");
  EXPECT_TRUE(out.cracks.empty());
  EXPECT_LT(out.energy_drift, 1e-5);
}

struct Strength {
  double newton;
  std::size_t broken;
};
class Breaking : public testing::TestWithParam<Strength> {};

// Bonds of 9.5, 10 and 10.5 MN: the first crack at 29.6 to 30.0 ms at the fixed end, and the reference's
// number of broken bonds over 45 ms (by 32 ms there are 5, 1 and 1).
TEST_P(Breaking, CracksAtTheFixedEnd) {
  const Outcome out = run_cantilever(GetParam().newton, 0.045);
  EXPECT_EQ(out.cracks.size(), GetParam().broken);
  ASSERT_FALSE(out.cracks.empty());
  const auto& first = out.cracks.front();
  const double time = static_cast<double>(first.step()) * out.dt;
  EXPECT_NEAR(time, 0.0298, 0.0003);
  EXPECT_EQ(first.mode(), wire::Crack::TENSILE);
  EXPECT_NEAR(first.x(), 9.87, 0.01);
  EXPECT_LT(out.energy_drift, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Strengths, Breaking,
                         testing::Values(Strength{9.5e6, 13}, Strength{10e6, 7}, Strength{10.5e6, 1}));

}  // namespace
}  // namespace adit::dem::cantilever_test
