// Requirement: no accepted scene creates energy. Bars with random zones, particles, overlaps, weights,
// materials, solves, substeps and time steps are struck and then move freely for 2000 steps.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupler/stepping/stepper.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/verification/bridging/bars.hpp"

namespace adit::random_bars_test {
namespace {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

// Evenly over orders of magnitude.
double magnitude(double low, double high) {
  return std::pow(10, between(std::log10(low), std::log10(high)));
}

scene::Material random_material() {
  scene::Material material;
  material.set_young_modulus(test::kYoung * magnitude(1e-3, 1e3));
  material.set_density(test::kDensity * magnitude(1e-2, 1e2));
  material.set_poisson_ratio(between(0, 1.0 / 3));
  return material;
}

scene::Scene random_bar(const test::Bar& bar) {
  scene::Scene scene = test::scene_of(bar, *rc::gen::element(scene::CONSISTENT, scene::LUMPED, scene::SPLIT));
  *scene.mutable_regions(0)->mutable_continuum()->mutable_material() = random_material();
  *scene.mutable_regions(1)->mutable_particles()->mutable_material() = random_material();
  scene.mutable_interfaces(0)->set_weight_floor(magnitude(1e-6, 1e-1));
  scene.mutable_time()->set_dt_factor(between(0.1, 1));
  scene.mutable_time()->set_substeps(*rc::gen::element(1U, 2U, 4U, 6U));
  return scene;
}

// Zones of 1.5 to 5 particles; overlaps from one particle's width on, anywhere between grid lines.
test::Bar random_geometry() {
  const double zone = magnitude(0.25, 1), radius = zone / 2 / magnitude(1.5, 5);
  const double width = between(2 * radius, 2), begin = between(3, 4);
  const double end = begin + width, last_zone = std::ceil(end / zone) * zone;
  return {
      "",
      {{test::Stretch::kGrid, 0, last_zone, zone}, {test::Stretch::kLattice, begin - 4 * radius, 8, radius}},
      {{0, 1, begin, end}}};
}

RC_GTEST_PROP(RandomBars, MakeNoEnergy, ()) {
  const test::Bar bar = random_geometry();
  scene::Scene scene = random_bar(bar);
  double dt = 0;
  try {
    dt = test::local_model(scene).dt;
  } catch (const protocol::UserError&) {
    RC_DISCARD("refused, as rows of particles that do not fill the bar");
  }
  test::push_left_end({3, 1, 100 * dt}, bar, scene);
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  double before = 0, rise = 0, peak = 0, worst = 0;
  for (std::uint64_t n = 0; n <= 2000; ++n) {
    stepper.step(n, {.energies = true});
    const double unexplained = stepper.ledger().unexplained();
    peak = std::max(peak, stepper.ledger().stored());
    rise = std::max(rise, unexplained - before);
    before = unexplained;
    worst = std::max(worst, stepper.ledger().drift());
  }
  RC_ASSERT(peak > 0);
  RC_ASSERT(worst <= 0.2);  // what a run is stopped at
  if (model.substeps == 1) {
    RC_ASSERT(rise <= 1e-8 * peak);
  }
}

}  // namespace
}  // namespace adit::random_bars_test
