// Requirement: soil column and fdm_server's continuum agree on a soft layer to 1 %: a narrow strip whose
// points move sideways only is that layer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupler/stepping/stepper.hpp"
#include "protocol/motion/motion.hpp"
#include "simplified/run.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::column_fdm_test {
namespace {

constexpr double kVelocity = 200, kDensity = 1900, kDuration = 1.2;

scene::Scene column_scene() {
  return testing::scene_of(R"(
    time { duration: 1.2 dt: 1e-3 }
    output { history_interval: 1e-3 }
    simplified {
      model: COLUMN
      ground { modes: 25 column_spacing: 100
        profiles { chainage: 0 layers { thickness: 20 shear_velocity: 200 density: 1900 damping_ratio: 0 } }
        profiles { chainage: 100 layers { thickness: 20 shear_velocity: 200 density: 1900 damping_ratio: 0 } } }
      excitation { motion { ricker { frequency: 4 time: 0.5 } baseline: false } lateral: 1 through_ground: true }
      stations { name: "surface" chainage: 0 }
    })");
}

// The same layer as a strip of zones; its foot moves as the rock does.
scene::Scene strip_scene(const motion::Motion& motion) {
  scene::Scene scene = testing::scene_of(R"(
    material { poisson_ratio: 0.3 density: 1900 }
    continuum {
      block { x_min: 0 x_max: 0.5 y_min: 0 y_max: 20 zones_x: 1 zones_y: 80 }
      motions { where {} velocity { y: 0 } }
      motions { where { y_max: 0 } velocity { x: 1 } }
      histories { name: "surface" quantity: DISPLACEMENT_X at { x: 0 y: 20 } }
    })");
  scene.mutable_time()->set_duration(kDuration);
  scene.mutable_time()->set_dt(2e-4);
  scene.mutable_material()->set_young_modulus(2 * 1.3 * kDensity * kVelocity * kVelocity);
  auto& table = *scene.mutable_continuum()->mutable_motions(1)->mutable_time()->mutable_table();
  const motion::Course course = motion::integrate(motion);
  for (std::size_t n = 0; n < course.velocity.size(); ++n) {
    table.add_time(static_cast<double>(n) * motion.dt);
    table.add_value(course.velocity[n]);
  }
  return scene;
}

TEST(Column, AgreesWithTheContinuumOnASoftLayer) {
  const scene::Scene scene = column_scene();
  const simplified::Setup setup = set_up(scene);
  const Response column = solve(setup, shake(setup));

  coupler::Model model = test::local_model(strip_scene(setup.motion.motion));
  coupler::Stepper stepper(model);
  const auto ratio = static_cast<std::uint64_t>(std::round(1e-3 / model.dt));
  double largest = 0, difference = 0;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = false, .histories = true});
    if (n % ratio != 0) continue;
    const double of_column = column.histories.rows[n / ratio][1];
    largest = std::max(largest, std::abs(of_column));
    difference = std::max(difference, std::abs(of_column - model.participants[0].prediction().histories(0)));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 0.01 * largest);
}

}  // namespace
}  // namespace adit::simplified::column_fdm_test
