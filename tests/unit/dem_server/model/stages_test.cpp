// Requirement: particles change with stages of excavation as the scene says, and what cannot change is
// refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/participant/choose_engine.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::stages_test {
namespace {

// Six columns and four rows of discs of radius 0.5 m: the middle two columns are excavated in stage 1, and a
// group of twice the density takes their place in stage 3.
scene::Scene staged() {
  auto scene = test::square_scene(6, 4);
  scene.mutable_statics();
  auto& excavation = *scene.mutable_particles()->add_excavations();
  excavation.mutable_where()->set_x_min(2);
  excavation.mutable_where()->set_x_max(4);
  excavation.set_stage(1);
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("plug");
  *group.mutable_where() = excavation.where();
  *group.mutable_material() = scene.material();
  group.mutable_material()->set_density(2 * test::kDensity);
  group.set_stage(3);
  return scene;
}

std::size_t count(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::ranges::count(flags, true));
}

TEST(ParticleStages, TakeAwayAndBringBack) {
  const Model model = read_model(staged());
  EXPECT_TRUE(model.present.empty());
  EXPECT_EQ(*std::ranges::max_element(model.group), 0u);
  EXPECT_EQ(model.bonds.size(), 5u * 4 + 6 * 3);
  ASSERT_EQ(model.stages.size(), 2u);
  const ParticleStage &gone = model.stages[0], &back = model.stages[1];
  EXPECT_EQ(gone.number, 1u);
  EXPECT_EQ(count(gone.present), 16u);
  EXPECT_EQ(gone.bonds.size(), 2u * (4 + 2 * 3));
  EXPECT_EQ(count(gone.fresh), 0u);
  EXPECT_EQ(back.number, 3u);
  EXPECT_EQ(count(back.present), 24u);
  EXPECT_EQ(count(back.fresh), 8u);
  EXPECT_EQ(back.bonds.size(), model.bonds.size());
  for (std::size_t i = 0; i < 24; ++i)
    EXPECT_DOUBLE_EQ(back.mass[i], (back.fresh[i] ? 2 : 1) * model.mass[i]);
}

// Every disc whose group changes begins afresh, the first one of the packing, too.
TEST(ParticleStages, BeginAfreshWithTheFirstDisc) {
  auto scene = staged();
  scene.mutable_particles()->clear_excavations();
  auto& where = *scene.mutable_particles()->mutable_groups(0)->mutable_where();
  where.set_x_min(0);
  where.set_x_max(1);
  scene.mutable_particles()->mutable_groups(0)->set_stage(1);
  auto& later = *scene.mutable_particles()->add_groups();
  later = scene.particles().groups(0);
  later.set_name("second plug");
  later.set_stage(2);
  const Model model = read_model(scene);
  ASSERT_EQ(model.stages.size(), 2u);
  const auto& fresh = model.stages[1].fresh;
  EXPECT_EQ(count(fresh), 4u);
  for (std::size_t i = 0; i < fresh.size(); ++i) EXPECT_EQ(fresh[i], model.discs.x[i] < 1) << "disc " << i;
}

// What an excavation does not release at once is held by what vanishes, and let go in the stage that follows.
TEST(ParticleStages, HoldAShareUntilTheNextStage) {
  auto scene = staged();
  scene.mutable_particles()->mutable_excavations(0)->set_released(0.3);
  const Model model = read_model(scene);
  ASSERT_EQ(model.stages.size(), 3u);
  EXPECT_EQ(model.stages[1].number, 2u);
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_DOUBLE_EQ(model.stages[0].held[i], model.stages[0].present[i] ? 0 : 0.7);
    EXPECT_EQ(model.stages[1].held[i], 0);
  }
}

// A joint without a stage begins with the groups that it parts; a fault through ground is always there.
TEST(ParticleStages, JointsBeginWithTheirGroups) {
  const auto bonds_of = [](double x, std::optional<std::uint32_t> stage) {
    auto scene = staged();
    auto& joint = *scene.mutable_particles()->add_joints();
    test::set(*joint.mutable_from(), x, -1);
    test::set(*joint.mutable_to(), x, 5);
    joint.set_open(true);
    if (stage) joint.set_stage(*stage);
    const Model model = read_model(scene);
    std::vector<std::size_t> bonds{model.bonds.size()};
    for (const ParticleStage& one : model.stages) bonds.push_back(one.bonds.size());
    return bonds;
  };
  const std::size_t all = 38, gone = 20;
  EXPECT_EQ(bonds_of(3, {}), (std::vector<std::size_t>{all, gone, all - 4}));
  EXPECT_EQ(bonds_of(1, {}), (std::vector<std::size_t>{all - 4, gone - 4, all - 4}));
  EXPECT_EQ(bonds_of(3, 0), (std::vector<std::size_t>{all - 4, gone, all - 4}));
  EXPECT_EQ(bonds_of(1, 3), (std::vector<std::size_t>{all, gone, all - 4}));
}

// Discs that were taken away have no mass, no bonds, and are not drawn; those that come back bear nothing.
TEST(ParticleStages, ChangeTheEngine) {
  const Model model = read_model(staged());
  GeneralEngine engine(model, 1);
  Particles& p = engine.particles();
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 1e-3 * p.x[i];
  const auto drawn = [&] {
    wire::Snapshot snapshot;
    engine.snapshot(snapshot);
    return snapshot.pieces(0).connectivity_size();
  };
  const auto largest_force_of_plug = [&] {
    double most = 0;
    engine.for_each_bond([&](const ObservedPair& bond) {
      const double x = (p.x[bond.first] + p.x[bond.second]) / 2;
      if (x > 1.6 && x < 4.4) most = std::max({most, std::abs(bond.normal), std::abs(bond.shear)});
    });
    return most;
  };
  EXPECT_EQ(drawn(), 24);
  EXPECT_GT(largest_force_of_plug(), 1);
  engine.begin_stage(1);
  EXPECT_EQ(drawn(), 16);
  EXPECT_EQ(engine.fragments(), 2u);
  EXPECT_EQ(largest_force_of_plug(), 0);
  engine.begin_stage(3);
  EXPECT_EQ(drawn(), 24);
  EXPECT_EQ(engine.fragments(), 1u);
  EXPECT_LT(largest_force_of_plug(), 1e-6);
}

// What is put beside ground that has come towards it touches it without force, and resists what comes after.
TEST(ParticleStages, PutDiscsBesideWhatHasMovedTowardsThem) {
  auto scene = staged();
  for (auto* where : {scene.mutable_particles()->mutable_excavations(0)->mutable_where(),
                      scene.mutable_particles()->mutable_groups(0)->mutable_where()}) {
    where->Clear();
    where->set_y_min(2);
  }
  auto& joint = *scene.mutable_particles()->add_joints();
  test::set(*joint.mutable_from(), -1, 2);
  test::set(*joint.mutable_to(), 7, 2);
  joint.set_open(true);
  GeneralEngine engine(read_model(scene), 1);
  Particles& p = engine.particles();
  const auto raise_the_ground = [&](double by) {
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p.y[i] < 2) p.uy[i] += by;
  };
  const auto largest_force = [&] {
    double most = 0;
    engine.for_each_contact(
        [&](const ObservedPair& contact) { most = std::max(most, std::abs(contact.normal)); });
    return most;
  };
  engine.begin_stage(1);
  raise_the_ground(1e-3);
  engine.begin_stage(3);
  EXPECT_EQ(engine.fragments(), 2u);
  EXPECT_LT(largest_force(), 1e-6);
  raise_the_ground(1e-3);
  EXPECT_GT(largest_force(), 1e3);
}

// A section goes on to tell the force of the bonds that cross it, whose numbers a stage changes.
TEST(ParticleStages, LeaveSectionsWhatCrossesThem) {
  auto scene = staged();
  auto& section = *scene.mutable_particles()->add_sections();
  section.set_name("right");
  test::set(*section.mutable_from(), 5, -1);
  test::set(*section.mutable_to(), 5, 5);
  auto& history = *scene.mutable_particles()->add_histories();
  history.set_name("right");
  history.set_quantity(scene::THRUST);
  history.set_section("right");
  GeneralEngine engine(read_model(scene), 1);
  engine.watch(scene.particles());
  Particles& p = engine.particles();
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 1e-3 * p.x[i];
  const auto thrust = [&] {
    std::vector<double> values;
    engine.read_histories({0, 1e-6}, values);
    return values.at(0);
  };
  const double before = thrust();
  EXPECT_GT(before, 1);
  for (const std::uint32_t stage : {1u, 3u}) {
    engine.begin_stage(stage);
    EXPECT_NEAR(thrust(), before, 1e-12 * before) << stage;
  }
}

// A circle inside of what is taken away holds nothing but pores; around a larger one stand four discs with
// three neighbours.
TEST(ParticleStages, LeaveCirclesWhatIsThere) {
  auto scene = staged();
  const auto add = [&](scene::Quantity quantity, double radius) {
    auto& history = *scene.mutable_particles()->add_histories();
    history.set_name(scene::Quantity_Name(quantity));
    history.set_quantity(quantity);
    test::set(*history.mutable_at(), 3, 2);
    history.set_radius(radius);
  };
  add(scene::POROSITY, 1);
  add(scene::COORDINATION, 2);
  add(scene::STRAIN_RATE_XX, 2);
  GeneralEngine engine(read_model(scene), 1);
  engine.watch(scene.particles());
  const auto values = [&] {
    Particles& p = engine.particles();
    for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = p.is_there(i) ? 0.5 * p.x[i] : 0;
    std::vector<double> read;
    engine.read_histories({0, 1e-6}, read);
    return read;
  };
  EXPECT_NEAR(values()[0], 1 - std::numbers::pi / 4, 0.05);
  EXPECT_GT(values()[1], 3.5);
  engine.begin_stage(1);
  EXPECT_NEAR(values()[0], 1, 1e-12);
  EXPECT_NEAR(values()[1], 3, 1e-12);
  EXPECT_NEAR(values()[2], 0.5, 1e-12);
  engine.begin_stage(3);
  EXPECT_GT(values()[1], 3.5);
}

TEST(ParticleStages, AskForTheGeneralEngineAndForStatics) {
  auto lattice = staged();
  lattice.mutable_particles()->clear_square_packing();
  auto& packing = *lattice.mutable_particles()->mutable_packing();
  test::set_box(packing, 6, 4);
  packing.set_radius(0.5);
  EXPECT_EQ(choose_engine(scene::Particles::AUTOMATIC, read_model(lattice)).reason,
            "its particles change by stages");
  adit::test::expect_refusal([&] { choose_engine(scene::Particles::LATTICE, read_model(lattice)); },
                             "particles.engine", "its particles change by stages");
  auto hasty = staged();
  hasty.clear_statics();
  adit::test::expect_refusal([&] { read_model(hasty); }, "particles.excavations[0].stage", "has no statics");
}

TEST(ParticleStages, AreRefusedInAnOverlap) {
  const Model model = read_model(staged());
  std::vector<double> centres(model.discs.size()), midpoints(model.bonds.size(), 1.0);
  for (std::size_t i = 0; i < centres.size(); ++i) centres[i] = model.discs.x[i] < 3 ? 0.5 : 1;
  for (std::size_t k = 0; k < midpoints.size(); ++k)
    if (model.discs.x[model.bonds[k].first] < 3) midpoints[k] = 0.5;
  adit::test::expect_refusal(
      [&] {
        weigh(model, {centres, midpoints, 1e-3});
      },
      "particles.excavations", "keep what changes away from the overlap");
}

}  // namespace
}  // namespace adit::dem::stages_test
