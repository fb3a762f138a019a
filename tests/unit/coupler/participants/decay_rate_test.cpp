// Requirement: the rate at which `split` lets the fine motion decay follows what the participants compute,
// and is asked for where they do not say.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <limits>

#include "coupler/stepping/stepper.hpp"
#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::coupler::decay_rate_test {
namespace {

// A bar of 4 m, pulled at the particles' end.
scene::Scene split_bar() {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.01 dt: 5e-5 }
    continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 } }
    particles {
      packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.1 }
      loads { where { x_min: 3.9 } force { x: 1e5 } }
    }
    interface { solve: SPLIT overlap { particles_begin { x: 1 y: 0 } continuum_ends { x: 3 y: 0 } } }
  )",
                                                            &scene));
  return scene;
}

// Velocities at the coupling points after 100 steps.
std::vector<double> velocities(const scene::Scene& scene) {
  Model model = test::local_model(scene);
  Stepper stepper(model);
  for (std::uint64_t n = 0; n <= 100; ++n) stepper.step(n, {});
  return model.participants[1].predicted;
}

// Stiffnesses given as numbers replace the modulus, which then means nothing.
TEST(DecayRate, FollowsTheStiffnessOfTheBondsNotTheScenesModulus) {
  scene::Scene given = split_bar();
  const dem::BondStiffness stiffness = dem::calibrate(1e9, 0.2, dem::Plane::kStress);
  auto& bonds = *given.mutable_particles()->mutable_bonds();
  bonds.set_normal_stiffness(stiffness.normal);
  bonds.set_shear_stiffness(stiffness.shear);
  *given.mutable_particles()->mutable_material() = given.material();
  given.mutable_particles()->mutable_material()->set_young_modulus(7e9);
  EXPECT_EQ(velocities(given), velocities(split_bar()));
  scene::Scene slower = split_bar();
  slower.mutable_interface()->set_decay_rate(100);
  EXPECT_NE(velocities(slower), velocities(split_bar())) << "the test must see the rate";
}

// It is 25 compression wave speeds over the overlap's width.
TEST(DecayRate, IsThatOfTheFineModelsCompressionWaves) {
  const Model model = test::local_model(split_bar());
  scene::Scene given = split_bar();
  given.mutable_interface()->set_decay_rate(25 * model.participants[1].model.p_wave_speed() / 2);
  EXPECT_EQ(velocities(given), velocities(split_bar()));
}

// A participant that says another wave speed than its own.
class Pretender : public protocol::Participant {
 public:
  explicit Pretender(double wave_speed) : wave_speed_(wave_speed) {}
  void set_up(const wire::Setup& setup, wire::Model& model) override {
    particles_.set_up(setup, model);
    model.set_p_wave_speed(wave_speed_);
  }
  void weigh(const wire::Weights& weights, wire::Interface& interface) override {
    particles_.weigh(weights, interface);
  }
  void couple(const wire::Couple& couple, wire::Operator& op) override { particles_.couple(couple, op); }
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override {
    particles_.advance(advance, predicted);
  }
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override {
    particles_.snapshot(request, snapshot);
  }
  void finish(wire::Bye& bye) override { particles_.finish(bye); }

 private:
  dem::DemParticipant particles_;
  double wave_speed_;
};

Model model_with(double wave_speed, const scene::Scene& scene) {
  std::vector<Participant> participants = test::local_participants(scene);
  participants[1].connection =
      std::make_unique<test::LocalConnection>("foreign_server", std::make_unique<Pretender>(wave_speed));
  return set_up(scene, std::move(participants), "test");
}

TEST(DecayRate, IsAskedForWhereTheParticipantDoesNotSay) {
  scene::Scene scene = split_bar();
  try {
    model_with(0, scene);
    FAIL() << "accepted";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "interface.decay_rate");
    EXPECT_THAT(error.what(),
                testing::HasSubstr("foreign_server does not say how fast waves run in `particles`"));
  }
  scene.mutable_interface()->set_decay_rate(1000);
  EXPECT_NO_THROW(model_with(0, scene));
  scene = split_bar();
  scene.mutable_interface()->set_solve(scene::CONSISTENT);
  EXPECT_NO_THROW(model_with(0, scene));
}

TEST(DecayRate, AWaveSpeedThatIsNoneLosesThePeer) {
  for (const double speed : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(model_with(speed, split_bar()), protocol::PeerLost) << speed;
}

}  // namespace
}  // namespace adit::coupler::decay_rate_test
