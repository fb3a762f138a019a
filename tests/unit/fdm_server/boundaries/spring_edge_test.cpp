// Requirements on quiet edges with springs: what they give way to a lasting force, energy, stability.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fdm_server/model/boundaries/boundaries.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::spring_edge_test {
namespace {

constexpr double kShear = 25e9 / 2.4, kForce = 1e6, kHeight = 1;

// A beam of 6 by 1 m that leans on a quiet edge at x = 0, pushed at its other end.
std::string pushed(double source_distance, const char* axis) {
  return fmt::format(
      "quiet {{ where {{ x_max: 0 }} source_distance: {} }} edge_loads {{ where {{ x_min: 6 }} force {{ {}: "
      "{} }} }} "
      "motions {{ where {{ }} velocity {{ {}: 0 }} }} "
      "histories {{ name: 'edge' quantity: DISPLACEMENT_{} at {{ x: 0 y: 0.5 }} }} ",
      source_distance, axis, kForce, *axis == 'x' ? "y" : "x", *axis == 'x' ? "X" : "Y");
}

// Under a lasting force an edge comes to rest where its springs balance it: G/R across the edge, half of it
// along. Energy closes on the way.
TEST(SpringEdge, GivesWayToALastingForceAsFarAsItsSpringsSay) {
  for (const auto& [axis, stiffness] : {std::pair{"x", kShear / 10}, {"y", kShear / 20}}) {
    Conversation run(pushed(10, axis));
    const double dt = 0.9 * run.model.critical_dt();
    double most = 0, begin = 0;  // half a kick
    for (std::uint64_t step = 0; step <= 40000; ++step) {
      run.advance(step, dt);
      const auto& e = run.predicted.energies();
      const double total = e.kinetic() + e.strain() + e.dissipated() - e.external_work();
      if (step == 0) begin = total;
      most = std::max(most, std::abs(total - begin));
    }
    EXPECT_NEAR(run.predicted.histories(0), kForce / (stiffness * kHeight),
                1e-3 * kForce / (stiffness * kHeight))
        << axis;
    EXPECT_LT(most, 1e-9 * kForce * kForce / stiffness) << axis;
  }
}

// Without springs it goes on for ever, at the velocity that the dashpots allow.
TEST(SpringEdge, IsWhatKeepsALastingForceFromMovingTheGround) {
  Conversation run(
      "quiet { where { x_max: 0 } } edge_loads { where { x_min: 6 } force { x: 1e6 } } "
      "motions { where { } velocity { y: 0 } } "
      "histories { name: 'edge' quantity: DISPLACEMENT_X at { x: 0 y: 0.5 } }");
  const double dt = 0.9 * run.model.critical_dt();
  double before = 0;
  for (std::uint64_t step = 0; step <= 40000; ++step) {
    run.advance(step, dt);
    if (step == 20000) before = run.predicted.histories(0);
  }
  EXPECT_NEAR(run.predicted.histories(0) / before, 2, 0.01);
}

// What springs add to a zone's stiffness: 2 l G / (R area) for each of its edges of length l, two in a
// corner.
TEST(SpringEdge, StiffensZonesByLengthOverArea) {
  const scene::Scene scene =
      setup_of(
          "quiet { where { x_max: 0 } source_distance: 20 } quiet { where { y_max: 0 } source_distance: 40 }")
          .scene();
  const Grid grid = make_grid({0, 6, 0, 1, 12, 4});  // zones of 0.5 by 0.25 m
  const Ground ground{{{2500, 25e9, 0.2}}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  const double per_distance = 2 * kShear / (0.5 * 0.25);
  EXPECT_NEAR(spring_stiffness(scene.continuum(), grid, ground) / per_distance, 0.25 / 20 + 0.5 / 40, 1e-12);
}

// The critical step holds with springs as stiff as may be: just below it nothing grows.
TEST(SpringEdge, StiffSpringsShortenTheCriticalStep) {
  const double without = Conversation(pushed(1e9, "x")).model.critical_dt();
  Conversation run(pushed(0.01, "x"));
  const double dt = 0.999 * run.model.critical_dt();
  EXPECT_LT(dt, 0.7 * without);
  for (std::uint64_t step = 0; step <= 20000; ++step) run.advance(step, dt);
  // what the push alone stores in the beam
  EXPECT_LT(run.predicted.energies().kinetic(), kForce * kForce * 6 / (2 * kShear));
}

}  // namespace
}  // namespace adit::fdm::test::spring_edge_test
