// The joint of an immersed tunnel as a coupled scene in plan has the stiffness, the mass and the force laws
// of the beam model.
#include <gmock/gmock.h>

#include <cmath>

#include "protocol/scene/fields/check_rules.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/run.hpp"
#include "simplified/zoom/plan_joint.hpp"
#include "simplified/zoom/plan_scene.hpp"
#include "simplified/zoom/slab.hpp"
#include "simplified/zoom/write.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/scenes.hpp"

namespace adit::simplified::plan_test {
namespace {

// Joints every 25 m, the middle one at 100 m.
scene::Scene gasket_tunnel() {
  scene::Scene scene = testing::immersed_tunnel();
  scene.mutable_simplified()->mutable_zoom()->set_width(100);
  scene::Joints& joints = *scene.mutable_simplified()->mutable_tunnel()->mutable_joints(0);
  joints.clear_axial_stiffness();
  joints.mutable_lateral_keys()->set_stiffness(3e9);
  joints.mutable_lateral_keys()->set_clearance(0.005);
  scene::Gasket& gasket = *joints.mutable_gasket();
  for (const double c : {0.0, 0.1, 0.2}) gasket.add_compression(c);
  for (const double f : {0.0, 1e8, 4e8}) gasket.add_force(f);
  gasket.set_installed_force(1.6e8);  // 0.12 m
  joints.mutable_cables()->set_stiffness(1e9);
  joints.mutable_cables()->set_slack(0.01);
  return scene;
}

// The total force of the springs whose name begins so, at an opening of all rows.
double force(const scene::Particles& particles, const std::string& kind, double opening) {
  double sum = 0;
  for (const scene::ParticleSpring& spring : particles.springs()) {
    if (!spring.name().starts_with(kind)) continue;
    const auto& curve = spring.curve();
    int k = 1;
    while (k + 1 < curve.opening_size() && curve.opening(k) < opening) ++k;
    const double share = (opening - curve.opening(k - 1)) / (curve.opening(k) - curve.opening(k - 1));
    sum += curve.force(k - 1) + share * (curve.force(k) - curve.force(k - 1));
  }
  return sum;
}

struct Planned {
  scene::Scene scene;
  PlanScene plan;
};

Planned planned() {
  const scene::Scene scene = gasket_tunnel();
  const auto setup = set_up(scene);
  const Response response = solve(setup, shake(setup));
  const Window around = window(response.fields, 100, 100);
  return {scene, plan_scene(setup, response, 3, around, "worst-opening", 2)};
}

// Requirement: the slab has EA, EI and mass per metre of the section.
TEST(Slab, HasTheStiffnessAndTheMassOfTheSection) {
  const scene::Section section = gasket_tunnel().simplified().tunnel().sections(0);
  const Slab slab = slab_of(section);
  EXPECT_NEAR(slab.young_modulus * slab.width, 35e9 * 158, 1);
  EXPECT_NEAR(slab.young_modulus * std::pow(slab.width, 3) / 12, 35e9 * 2.4e4, 1e3);
  EXPECT_NEAR(slab.density * slab.width, 4e5, 1e-6);
}

// Requirement: at any opening the springs together bear what gaskets, cables and keys of the section bear.
TEST(PlanJoint, BearsTheForcesOfTheJoint) {
  const scene::Particles particles = planned().plan.scene.particles();
  // From the installed state: 1.6e8 N at 0.12 m, 1e8 N/0.1 m and 3e8 N/0.1 m on the pieces of the load curve.
  EXPECT_NEAR(force(particles, "gasket", 0), 0, 1e-3);
  EXPECT_NEAR(force(particles, "gasket", 0.01), 3e7, 1);
  EXPECT_NEAR(force(particles, "gasket", 0.02), 6e7, 1);
  EXPECT_NEAR(force(particles, "gasket", 0.07), 1.1e8, 1);
  EXPECT_NEAR(force(particles, "gasket", 0.2), 1.6e8, 1);  // it has let go
  EXPECT_NEAR(force(particles, "gasket", -0.03), -9e7, 1);
  EXPECT_NEAR(force(particles, "spring", -0.1), 0, 1e-3);
  EXPECT_NEAR(force(particles, "spring", 0.015), 5e6, 1);
  double keys = 0, lever = 0;
  for (const scene::ParticleSpring& spring : particles.springs()) {
    if (!spring.name().starts_with("key")) continue;
    keys += spring.stiffness();
    lever += spring.stiffness() * spring.from().y();
    EXPECT_EQ(spring.clearance(), 0.005);
  }
  EXPECT_NEAR(keys, 3e9, 1);
  EXPECT_NEAR(lever, 0, 1);
}

// Requirement: a row's share acts where the spring of the beam does: the rotation stiffness at rest is the
// same but for the width of a row.
TEST(PlanJoint, TurnsAsStifflyAsTheJoint) {
  const auto [scene, plan] = planned();
  const beam::Tunnel tunnel = beam_model(scene.simplified(), divide(scene.simplified().tunnel()));
  double of_beam = 0, of_rows = 0;
  for (const auto& gasket : tunnel.joints[3].gaskets)
    of_beam += 3e9 * gasket.length / 98 * gasket.y * gasket.y;
  for (const scene::ParticleSpring& spring : plan.scene.particles().springs())
    if (spring.name().starts_with("gasket"))
      of_rows +=
          force(plan.scene.particles(), spring.name(), 1e-3) / 1e-3 * spring.from().y() * spring.from().y();
  EXPECT_NEAR(of_rows, of_beam, 0.03 * of_beam);
}

// Requirement: zones in which joints are spread stretch and bend as slab and joints do in series, and shear
// as they do where Poisson's ratio can tell it.
TEST(Spread, HasTheFlexibilityOfSlabAndJoints) {
  const scene::Scene scene = gasket_tunnel();
  const scene::Section section = scene.simplified().tunnel().sections(0);
  const Slab slab = slab_of(section);
  beam::Joint joint;
  for (const double side : {-1, 1}) joint.springs.push_back({side * 15, 0, beam::linear(1e10)});
  joint.lateral = beam::linear(7e9);
  const JointedSlab jointed = spread(section, slab, std::vector{joint, joint}, 40);
  const double w = slab.width, inner = jointed.inner_modulus, outer = jointed.outer_modulus;
  EXPECT_NEAR(40 / ((inner + outer) / 2 * w), 40 / (35e9 * 158) + 2 / 2e10, 1e-15);
  const double bending = (inner * std::pow(w / 2, 3) + outer * (std::pow(w, 3) - std::pow(w / 2, 3))) / 12;
  EXPECT_NEAR(40 / bending, 40 / (35e9 * 2.4e4) + 2 / (2e10 * 15 * 15), 1e-17);
  // No shear deformation of the section: keys alone.
  EXPECT_NEAR(5. / 6 * (inner + outer) / 2 * w / (2 * (1 + jointed.poisson_ratio)), 40 * 7e9 / 2, 1);
}

// Requirement: what lies between the halves of the next spans is the slab itself, and what lies beyond has
// the joints.
TEST(PlanScene, SpreadsTheOtherJoints) {
  const scene::Scene scene = planned().plan.scene;
  ASSERT_EQ(scene.continuum().materials_size(), 6);
  EXPECT_EQ(scene.continuum().materials(0).where().x_max(), 87.5);
  EXPECT_EQ(scene.continuum().materials(3).where().x_min(), 112.5);
  EXPECT_NO_THROW(protocol::check_rules(scene));
}

// Requirement: the ground holds each metre of the model as it holds the beam: along the axis on it, across it
// everywhere.
TEST(PlanScene, HasTheSoilSpringsOfTheBeam) {
  const scene::Scene scene = planned().plan.scene;
  const scene::Foundation &axial = scene.particles().foundations(0),
                          &lateral = scene.particles().foundations(1);
  const double width = scene.continuum().block().y_max() - scene.continuum().block().y_min();
  const double band = axial.where().y_max() - axial.where().y_min();
  EXPECT_NEAR(band, width / 8, 1e-9);
  EXPECT_NEAR(axial.x().stiffness() * band, 4e8, 1);
  EXPECT_NEAR(lateral.y().stiffness() * width, 4e8, 1);
  EXPECT_NEAR(lateral.y().dashpot() * width, 4e6, 1e-2);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(scene.particles().foundations(i).SerializeAsString(),
              scene.continuum().foundations(i).SerializeAsString());
}

TEST(CheckZoom, NamesThePlacesAndWhatIsMissing) {
  const auto refuse = [](const scene::Scene& scene, const char* place, const char* text) {
    adit::test::expect_refusal([&] { check_zoom(set_up(scene), place); }, "--zoom", text);
  };
  refuse(gasket_tunnel(), "worst-openin", "did you mean `worst-opening`?");
  scene::Scene scene = gasket_tunnel();
  scene.mutable_simplified()->set_model(scene::Simplified::CHAIN);
  refuse(scene, "worst-opening", "needs the model beam");
  scene = gasket_tunnel();
  scene.mutable_simplified()->clear_zoom();
  refuse(scene, "worst-opening", "zoom: {width: 90 m}");
  scene = gasket_tunnel();
  scene.mutable_simplified()->mutable_tunnel()->clear_joints();
  refuse(scene, "worst-opening", "needs a joint");
}

// Requirement: joints that lie too close together for particles between them are refused.
TEST(PlanScene, RefusesJointsWithoutRoomForParticles) {
  scene::Scene scene = gasket_tunnel();
  scene.mutable_simplified()->mutable_tunnel()->mutable_joints(0)->set_spacing(5);
  const auto setup = set_up(scene);
  const Response response = solve(setup, shake(setup));
  adit::test::expect_refusal(
      [&] { plan_scene(setup, response, 15, window(response.fields, 100, 100), "worst-opening", 2); },
      "simplified.zoom", "leaves 2.5 m of particles");
}

}  // namespace
}  // namespace adit::simplified::plan_test
