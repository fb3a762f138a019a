// Models that cannot be computed are refused by name before the first step.
#include "coupler/participants/set_up.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/local_participants.hpp"
#include "tests/support/refusals.hpp"

namespace adit::coupler::set_up_test {
namespace {

// A bar of 4 m: zones of 0.5 m, rows of particles, overlap from 1 m to 3 m.
scene::Scene coupled_bar() {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.01 }
    continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 } }
    particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.1 } }
    interface { overlap { particles_begin { x: 1 y: 0 } continuum_ends { x: 3 y: 0 } } }
  )",
                                                            &scene));
  return scene;
}

void expect_refusal(const scene::Scene& scene, const std::string& path, const std::string& text) {
  adit::test::expect_refusal([&] { test::local_model(scene); }, path, text);
}

TEST(SetUp, PutsCouplingPointsOnTheParticlesOfTheOverlap) {
  const Model model = test::local_model(coupled_bar());
  ASSERT_FALSE(model.coupling_points.empty());
  for (std::size_t i = 0; i < model.coupling_points.size(); i += 2) {
    EXPECT_GE(model.coupling_points[i], 1 - 1e-8);
    EXPECT_LE(model.coupling_points[i], 3 + 1e-8);
  }
  EXPECT_EQ(model.participants[0].counts.zones(), 12U);  // those behind the overlap are gone
}

// Requirement: particles inside a ring and in it, zones outside it and in it, both coupled in the ring; where
// both models end, the ring may stick out.
TEST(SetUp, JoinsZonesAroundParticlesOverARing) {
  scene::Scene scene = coupled_bar();
  auto& overlap = *scene.mutable_interface()->mutable_overlap();
  overlap.Clear();
  overlap.set_width(1);
  auto& box = *overlap.mutable_around()->mutable_box();
  box.set_x_min(1.5);
  box.set_x_max(2.5);
  box.set_y_min(-1);
  box.set_y_max(2);
  const Model model = test::local_model(scene);
  ASSERT_FALSE(model.coupling_points.empty());
  for (std::size_t i = 0; i < model.coupling_points.size(); i += 2) {
    const double from_the_middle = std::abs(model.coupling_points[i] - 2);
    EXPECT_GE(from_the_middle, 0.5 - 1e-8);
    EXPECT_LE(from_the_middle, 1.5 + 1e-8);
  }
  EXPECT_EQ(model.participants[0].counts.zones(), 12U);  // those between 1.5 m and 2.5 m are gone
  EXPECT_EQ(model.participants[1].counts.particles(),
            78U);  // rows of 16, two of them on the edges, and of 15
}

// Requirement: the last step ends on the duration, and no step is longer than what was asked for.
TEST(SetUp, DividesTheDurationIntoWholeSteps) {
  scene::Scene scene = coupled_bar();
  scene.mutable_time()->set_dt_factor(0.3);
  const Model model = test::local_model(scene);
  EXPECT_DOUBLE_EQ(model.dt * static_cast<double>(model.steps), 0.01);
  EXPECT_LE(model.dt, 0.3 * model.critical_dt * (1 + 1e-12));
  EXPECT_GT(model.dt, 0.29 * model.critical_dt);
}

TEST(SetUp, RefusesATimeStepAboveTheLimitAndNamesIt) {
  scene::Scene scene = coupled_bar();
  scene.mutable_time()->set_dt(1e-3);
  expect_refusal(scene, "time.dt", "the critical time step of the particles");
}

TEST(SetUp, RefusesAnOverlapOutsideTheModels) {
  scene::Scene scene = coupled_bar();
  scene.mutable_interface()->mutable_overlap()->mutable_continuum_ends()->set_x(5);
  expect_refusal(scene, "interface.overlap.continuum_ends", "outside `continuum`");
}

TEST(SetUp, RefusesARingBeyondTheParticles) {
  scene::Scene scene = coupled_bar();
  scene.mutable_particles()->mutable_packing()->set_x_max(2);
  auto& overlap = *scene.mutable_interface()->mutable_overlap();
  overlap.Clear();
  overlap.set_width(0.5);
  overlap.mutable_around()->mutable_circle()->mutable_centre()->set_x(2);
  overlap.mutable_around()->mutable_circle()->mutable_centre()->set_y(0.5);
  overlap.mutable_around()->mutable_circle()->set_radius(1);
  expect_refusal(scene, "interface.overlap", "not filled by `particles`");
}

TEST(SetUp, RefusesAnOverlapWithoutParticles) {
  scene::Scene scene = coupled_bar();
  scene.mutable_interface()->mutable_overlap()->mutable_particles_begin()->set_x(1.03);
  scene.mutable_interface()->mutable_overlap()->mutable_continuum_ends()->set_x(1.05);
  expect_refusal(scene, "interface.overlap", "holds no particle");
}

TEST(SetUp, RefusesModelsWithoutAnInterfaceAndAnInterfaceWithoutModels) {
  scene::Scene scene = coupled_bar();
  scene.clear_interface();
  expect_refusal(scene, "interface", "is missing");
  scene = coupled_bar();
  scene.clear_continuum();
  expect_refusal(scene, "interface", "joins `continuum`, but the scene has no model of this name");
  scene.clear_particles();
  expect_refusal(scene, "continuum", "give at least one");
}

TEST(SetUp, RefusesParticlesThatDoNotFillTheOverlap) {
  scene::Scene scene = coupled_bar();
  scene.mutable_particles()->mutable_packing()->set_y_max(0.5);
  expect_refusal(scene, "interface.overlap", "cross-section");
}

TEST(SetUp, RefusesTwoHistoriesOfOneColumn) {
  scene::Scene scene = coupled_bar();
  for (int i = 0; i < 2; ++i) {
    auto& history = *scene.mutable_particles()->add_histories();
    history.set_name("tip");
    history.set_quantity(scene::DISPLACEMENT_Y);
    history.mutable_at()->set_x(3.9);
    history.mutable_at()->set_y(0.5);
  }
  expect_refusal(scene, "particles.histories[1].name", "a second time");
}

TEST(SetUp, RefusesAHistoryFarFromEveryParticle) {
  scene::Scene scene = coupled_bar();
  auto& history = *scene.mutable_particles()->add_histories();
  history.set_name("tip");
  history.set_quantity(scene::DISPLACEMENT_Y);
  history.mutable_at()->set_x(0);  // particles begin at 1 m
  history.mutable_at()->set_y(0.5);
  expect_refusal(scene, "particles.histories[0].at", "nearest particle");
}

TEST(SetUp, RefusesASceneWithoutMaterialAndOneOfTheSimplifiedModels) {
  scene::Scene scene = coupled_bar();
  scene.clear_material();
  expect_refusal(scene, "material", "is missing");
  scene.mutable_simplified();
  expect_refusal(scene, "simplified", "program `simplified`");
}

// Requirement: errors that a participant finds keep their place in the scene.
TEST(SetUp, PassesOnWhatAParticipantRefuses) {
  scene::Scene scene = coupled_bar();
  auto& load = *scene.mutable_continuum()->add_point_loads();
  load.mutable_where()->set_x_min(3.9);  // there is no zone left
  load.mutable_force()->set_y(1);
  expect_refusal(scene, "continuum.point_loads[0].where", "selects no grid points");
}

}  // namespace
}  // namespace adit::coupler::set_up_test
