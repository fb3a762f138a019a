// Requirement: rock as stiff as the soil above it reflects nothing, in either kind of wave: the surface moves
// as the given outcrop, later by the time of travel through the soil.
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simplified/run.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::ground_test {
namespace {

constexpr double kDelay = 0.1, kStep = 1e-3;  // [s]

// Poisson's ratio 1/4 in soil and rock; a layer as deep as the wave goes in kDelay.
scene::Scene half_space(const char* direction, double thickness) {
  return testing::scene_of(fmt::format(R"(
    time {{ duration: 1.2 dt: 1e-3 }}
    output {{ history_interval: 1e-3 }}
    simplified {{
      model: COLUMN
      ground {{ modes: 40 column_spacing: 100 rock {{ density: 2000 shear_velocity: 200 }}
        profiles {{ chainage: 0 layers {{ thickness: {0} shear_velocity: 200 density: 2000 poisson_ratio: 0.25
                                          damping_ratio: 0 }} }} }}
      excitation {{ motion {{ ricker {{ frequency: 4 time: 0.5 }} baseline: false }} {1}: 1 through_ground: true }}
      stations {{ name: "surface" chainage: 0 }}
    }})",
                                       thickness, direction));
}

void expect_delayed_outcrop(const char* direction, double velocity) {
  const scene::Scene scene = half_space(direction, velocity * kDelay);
  const simplified::Setup setup = set_up(scene);
  const Response response = solve(setup, shake(setup));
  const motion::Motion outcrops = motion::lasting(setup.motion.motion, scene.time().duration());
  const auto delay = static_cast<std::size_t>(std::lround(kDelay / kStep));
  double largest = 0, difference = 0;
  for (std::size_t n = delay; n < response.histories.rows.size(); ++n) {
    const double outcrop = outcrops.acceleration[n - delay];
    largest = std::max(largest, std::abs(outcrop));
    difference = std::max(difference, std::abs(response.histories.rows[n][2] - outcrop));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 0.02 * largest);
}

TEST(Ground, OfTheRocksStiffnessPassesShearWavesUnchanged) {
  expect_delayed_outcrop("lateral", 200);
}

TEST(Ground, OfTheRocksStiffnessPassesCompressionWavesUnchanged) {
  expect_delayed_outcrop("vertical", std::numbers::sqrt3 * 200);
}

}  // namespace
}  // namespace adit::simplified::ground_test
