#include "dem_server/participant/participant.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"

namespace adit::dem::participant_test {
namespace {

using test::cantilever_scene;
using test::InProcessRun;
using testing::Contains;
using testing::HasSubstr;
using testing::MatchesRegex;

// The model names its critical step, its box, and asks for weights at every centre and bond midpoint.
TEST(Participant, DescribesItsModel) {
  const InProcessRun run(cantilever_scene());
  EXPECT_EQ(run.model.sample_points_size(), 2 * (698 + 1921));
  EXPECT_DOUBLE_EQ(run.model.sample_points(0), test::kCantileverRadius);
  EXPECT_NEAR(run.model.x_max(), 10, 1e-13);
  EXPECT_NEAR(run.model.y_max(), 9 * std::numbers::sqrt3 * test::kCantileverRadius, 1e-13);
  EXPECT_GT(run.model.critical_dt(), 1e-5);
  EXPECT_EQ(run.interface.particles(), 698u);
  EXPECT_EQ(run.interface.bonds(), 1921u);
  EXPECT_EQ(run.interface.points_size(), 0);
}

// Who waits for a random packing hears how far it is.
TEST(Participant, TellsHowFarItsPackingIs) {
  wire::Setup setup;
  auto& particles = *setup.mutable_scene()->mutable_particles();
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "random_packing { x_min: 0 x_max: 1 y_min: 0 y_max: 1 radius_min: 0.04 radius_max: 0.06 porosity: 0.16 "
      "stress: 1e5 } contacts { normal_stiffness: 1e8 } ",
      &particles));
  auto& material = *setup.mutable_scene()->mutable_material();
  material.set_young_modulus(1e9);
  material.set_poisson_ratio(0.2);
  material.set_density(2000);
  DemParticipant participant;
  std::vector<std::string> heard;
  participant.report_to([&](const std::string& how_far) { heard.push_back(how_far); });
  wire::Model model;
  participant.set_up(setup, model);
  EXPECT_THAT(heard, Contains(MatchesRegex("growing [0-9]+ discs: step 3 of 20")));
  EXPECT_THAT(heard, Contains(HasSubstr("isotropic stress")));
}

// Step 0 does not move: it predicts half a kick, F dt / 2 m, shared by the five loaded particles.
TEST(Participant, StepZeroIsHalfAKickFromRest) {
  auto scene = cantilever_scene();
  scene.mutable_particles()->mutable_loads(0)->clear_time();
  scene.mutable_particles()->mutable_histories(0)->set_quantity(scene::VELOCITY_Y);
  // Ask for a corner particle, which is loaded.
  scene.mutable_particles()->mutable_histories(0)->mutable_at()->set_y(0);
  InProcessRun run(scene);
  const double mass = cell_mass(2500, test::kCantileverRadius);
  EXPECT_EQ(run.advance().histories(0), 0) << "at rest at step 0";
  EXPECT_EQ(run.predicted.strongest(0).force(), 0);
  const double speed = 5e6 / 5 / mass * run.dt / 2;
  EXPECT_NEAR(run.predicted.energies().kinetic(), -0.5 * 5 * mass * speed * speed,
              1e-9 * mass * speed * speed);
  run.advance();
  EXPECT_NEAR(run.predicted.histories(0), speed, 1e-12 * speed);
}

// The same run twice gives the same bits.
TEST(Participant, RepeatsToTheLastBit) {
  auto scene = cantilever_scene();
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(2e6);
  InProcessRun a(scene), b(scene);
  for (int n = 0; n < 500; ++n) ASSERT_EQ(a.advance().SerializeAsString(), b.advance().SerializeAsString());
}

// A velocity that blows up ends the run with the step, the place and the value.
TEST(Participant, InstabilityNamesStepPlaceAndValue) {
  InProcessRun run(cantilever_scene(), {}, 50);
  try {
    for (int n = 0; n < 10000; ++n) run.advance();
    FAIL() << "ran on";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(),
                testing::MatchesRegex("step [0-9]+: the normal force of the bond at .*m is .*(nan|inf) N.*"));
  }
}

// As the continuum does, whoever chose the step: the scene must say that it is wanted.
TEST(Participant, RefusesAStepAboveTheCriticalOne) {
  InProcessRun run(cantilever_scene());
  run.dt = 1;
  try {
    run.advance();
    FAIL() << "accepted";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "time.dt");
    EXPECT_THAT(error.what(), testing::HasSubstr("is 1 s, above the particles' critical step of "));
  }
}

// Requests that no coupler should send are refused, not computed.
TEST(Participant, RefusesInconsistentSteps) {
  InProcessRun changed(cantilever_scene());
  changed.advance();
  changed.dt *= 2;
  EXPECT_THROW(changed.advance(), std::logic_error);
  InProcessRun negative(cantilever_scene());
  negative.dt = -1;
  EXPECT_THROW(negative.advance(), std::logic_error);
  InProcessRun pushed(cantilever_scene());
  EXPECT_THROW(pushed.advance({1.0, 2.0}), std::logic_error);
  InProcessRun uncoupled(cantilever_scene());
  uncoupled.advance();
  EXPECT_THROW(uncoupled.advance({1.0, 2.0}), std::logic_error);
}

// The snapshot draws every particle and bond, with values in their places.
TEST(Participant, SnapshotHoldsParticlesAndBonds) {
  auto scene = cantilever_scene();
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(2e6);
  InProcessRun run(scene);
  std::size_t cracks = 0;
  for (int n = 0; n < 600; ++n) cracks += run.advance().cracks_size();
  ASSERT_GT(cracks, 0u);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  ASSERT_EQ(snapshot.pieces_size(), 3);
  const auto field = [](const auto& fields, const std::string& name) -> const wire::Field& {
    for (const auto& f : fields)
      if (f.name() == name) return f;
    throw std::runtime_error("no field " + name);
  };
  const auto& particles = snapshot.pieces(0);
  EXPECT_EQ(particles.name(), "particles");
  EXPECT_EQ(particles.points_size(), 2 * 698);
  EXPECT_EQ(particles.connectivity_size(), 698);
  for (const auto& f : particles.point_fields())
    EXPECT_EQ(f.values_size(), static_cast<int>(698 * f.components())) << f.name();
  EXPECT_EQ(field(particles.point_fields(), "id").values(697), 697);
  EXPECT_EQ(field(particles.point_fields(), "radius_m").values(3), test::kCantileverRadius);
  const auto& bonds = snapshot.pieces(1);
  EXPECT_EQ(bonds.name(), "bonds");
  EXPECT_EQ(bonds.shape(), wire::Piece::LINES);
  EXPECT_EQ(bonds.connectivity_size(), 2 * 1921);
  std::size_t broken = 0;
  double largest = 0;
  for (const double state : field(bonds.cell_fields(), "state").values()) broken += state != 0;
  for (const double f : field(bonds.cell_fields(), "normal_force_N").values())
    largest = std::max(largest, std::abs(f));
  EXPECT_EQ(broken, cracks);
  EXPECT_EQ(largest, run.predicted.strongest(0).force());
}

// The farewell counts particle updates.
TEST(Participant, CountsUpdates) {
  InProcessRun run(cantilever_scene());
  for (int n = 0; n < 11; ++n) run.advance();
  wire::Bye bye;
  run.participant.finish(bye);
  EXPECT_EQ(bye.updates(), 6980u);
  EXPECT_GE(bye.cpu_seconds(), 0);
}

}  // namespace
}  // namespace adit::dem::participant_test
