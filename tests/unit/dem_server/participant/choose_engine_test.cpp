// Requirement: the engine follows from what is to be computed, never from what is only observed, and the
// choice comes with its reason.
#include "dem_server/participant/choose_engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dem_server/model/reading/read_model.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::choose_engine_test {
namespace {

using Spoil = std::function<void(scene::Particles&)>;

scene::Scene lattice_scene() {
  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 6, 5);
  packing.set_radius(0.5);
  return scene;
}

EngineChoice choose(const scene::Scene& scene) {
  return choose_engine(scene.particles().engine(), read_model(scene));
}

EngineChoice choose(const Spoil& spoil) {
  auto scene = lattice_scene();
  spoil(*scene.mutable_particles());
  return choose(scene);
}

// Loads, observation, and words that ask for nothing leave the lattice to its engine.
TEST(EngineChoice, OfALatticeIsItsEngine) {
  const std::vector<Spoil> words{[](auto&) {},
                                 [](auto& p) { p.mutable_bonds()->set_tensile_strength(1e6); },
                                 [](auto& p) { p.add_loads()->mutable_force()->set_x(1); },
                                 [](auto& p) { p.add_body_loads(); },
                                 [](auto& p) { p.add_motions()->mutable_velocity()->set_x(0); },
                                 [](auto& p) { p.add_histories()->set_radius(3); },
                                 [](auto& p) { p.mutable_damping(); },
                                 [](auto& p) { p.mutable_damping()->set_local(0); },
                                 [](auto& p) {
                                   p.mutable_contacts()->set_friction(0);
                                   p.mutable_bonds();
                                 },
                                 [](auto& p) { p.mutable_within()->set_x_max(4); },
                                 [](auto& p) { p.set_engine(scene::Particles::LATTICE); },
                                 [](auto& p) {
                                   auto& group = *p.add_groups();
                                   group.set_name("left");
                                   group.mutable_where()->set_x_max(3);
                                 }};
  for (std::size_t k = 0; k < words.size(); ++k) EXPECT_EQ(choose(words[k]).told(), "lattice") << k;
}

struct Case {
  std::string name, reason;
  Spoil spoil;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.name;
}
class MoreThanALattice : public testing::TestWithParam<Case> {};

// All else takes the general engine, says why, and is refused where the lattice's engine is asked for.
TEST_P(MoreThanALattice, IsToldAndRefusedByName) {
  EXPECT_EQ(choose(GetParam().spoil).told(), "general: " + GetParam().reason);
  try {
    choose([](auto& p) {
      GetParam().spoil(p);
      p.set_engine(scene::Particles::LATTICE);
    });
    FAIL() << "accepted";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "particles.engine");
    EXPECT_EQ(std::string(error.what()), "is lattice, but " + GetParam().reason +
                                             ", which it does not compute; change that, or choose general or "
                                             "automatic");
  }
}

void set_parallel(scene::Bonds& bonds) {
  bonds.mutable_parallel()->set_normal_stiffness(1e9);
  bonds.mutable_parallel()->set_shear_stiffness(1e9);
}

void add_joint(scene::Particles& p, const std::function<void(scene::ParticleJoint&)>& law) {
  auto& joint = *p.add_joints();
  test::set(*joint.mutable_from(), 3.1, 0);
  test::set(*joint.mutable_to(), 3.1, 5);
  law(joint);
}

INSTANTIATE_TEST_SUITE_P(
    All, MoreThanALattice,
    testing::Values(
        Case{"Square", "the particles are not packed hexagonally",
             [](auto& p) {
               p.clear_packing();
               test::set_box(*p.mutable_square_packing(), 4, 4);
               p.mutable_square_packing()->set_radius(0.5);
             }},
        Case{"Placed", "the particles differ in size",
             [](auto& p) {
               p.clear_packing();
               p.mutable_placed()->set_content("x_m,y_m,radius_m\n0,0,0.5\n0.9,0,0.4\n");
             }},
        Case{"PlacedLattice", "particles may start under the force of their overlaps",
             [](auto& p) {
               p.clear_packing();
               p.mutable_placed()->set_content("x_m,y_m,radius_m\n0,0,0.5\n1,0,0.5\n");
             }},
        Case{"Loose", "no bond joins particles", [](auto& p) { p.mutable_contacts(); }},
        Case{"Parallel", "parallel bonds join particles", [](auto& p) { set_parallel(*p.mutable_bonds()); }},
        Case{"Smooth", "smooth joints join particles",
             [](auto& p) {
               add_joint(p, [](auto& joint) {
                 joint.mutable_smooth()->set_normal_stiffness(1e9);
                 joint.mutable_smooth()->set_shear_stiffness(1e9);
               });
             }},
        Case{"Open", "particles touch that no bond joins",
             [](auto& p) { add_joint(p, [](auto& joint) { joint.set_open(true); }); }},
        Case{"WeakLine", "bonds have different stiffnesses or strengths",
             [](auto& p) {
               add_joint(p, [](auto& joint) { joint.mutable_bonds()->set_tensile_strength(1); });
             }},
        Case{"Friction", "friction is asked for",
             [](auto& p) {
               p.mutable_bonds();
               p.mutable_contacts()->set_friction(0.5);
             }},
        Case{"Dashpots", "contacts have dashpots",
             [](auto& p) {
               p.mutable_bonds();
               p.mutable_contacts()->set_shear_damping(0.1);
             }},
        Case{"SoftContacts", "contacts have another stiffness than bonds",
             [](auto& p) {
               p.mutable_bonds();
               p.mutable_contacts()->set_normal_stiffness(1e3);
             }},
        Case{"Walls", "there are walls",
             [](auto& p) {
               p.add_walls()->set_name("floor");
               test::set(*p.mutable_walls(0)->mutable_from(), 0, -1);
               test::set(*p.mutable_walls(0)->mutable_to(), 6, -1);
             }},
        Case{"Springs", "there are springs or bolts",
             [](auto& p) {
               auto& spring = *p.add_springs();
               test::set(*spring.mutable_from(), 0.5, 0.5);
               test::set(*spring.mutable_to(), 5.5, 0.5);
               spring.set_stiffness(1e6);
             }},
        Case{"QuietEdges", "there are quiet edges",
             [](auto& p) { p.add_quiet()->mutable_where()->set_x_max(0.6); }},
        Case{"LocalDamping", "damping is asked for", [](auto& p) { p.mutable_damping()->set_local(0.1); }},
        Case{"ViscousDamping", "damping is asked for", [](auto& p) { p.mutable_damping()->set_viscous(1); }}),
    [](const auto& info) { return info.param.name; });

// The general engine may be asked for, also for a lattice.
TEST(EngineChoice, MayBeTheGeneralEngine) {
  EXPECT_EQ(choose([](auto& p) { p.set_engine(scene::Particles::GENERAL); }).told(),
            "general: the scene asks for it");
}

// A stress at the start is no reason for either engine.
TEST(EngineChoice, KnowsNoInitialStress) {
  auto square = test::square_scene(4, 4);
  square.mutable_initial_stress()->set_xx(-1e6);
  EXPECT_EQ(choose(square).told(), "general: the particles are not packed hexagonally");
  auto lattice = test::empty_scene();
  auto& packing = *lattice.mutable_particles()->mutable_packing();
  test::set_box(packing, 6, 6);
  packing.set_radius(0.5);
  lattice.mutable_initial_stress()->set_xx(-1e6);
  EXPECT_EQ(choose(lattice).told(), "lattice");
}

}  // namespace
}  // namespace adit::dem::choose_engine_test
