// Requirements on particles of ground with water: cells are the undrained ground that the skeleton and its
// water are together, under its total stress; what cannot be is refused in one sentence.
#include "dem_server/model/solid/wet_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dem_server/model/reading/read_model.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::wet_ground_test {
namespace {

// Cells of 0.1 m in a box of 2 m by 1 m, of sand below 10 m of water.
scene::Scene sand() {
  auto scene = test::empty_scene();
  scene.set_plane(scene::PLANE_STRAIN);
  auto& cells = *scene.mutable_particles()->mutable_cells();
  test::set_box(cells, 2, 1);
  cells.set_size(0.1);
  auto& material = *scene.mutable_material();
  material.set_young_modulus(260e6);
  material.set_poisson_ratio(0.3);
  material.mutable_pores()->set_porosity(0.4);
  material.mutable_pores()->set_saturated_density(2000);
  scene.mutable_water()->set_level(11);
  return scene;
}

double bulk(const scene::Material& material) {
  return material.young_modulus() / (3 * (1 - 2 * material.poisson_ratio()));
}
double shear(const scene::Material& material) {
  return material.young_modulus() / (2 * (1 + material.poisson_ratio()));
}

void compute(scene::Scene scene) {
  fill_pores(scene);
  read_model(scene);
}

TEST(WetGround, HasTheStiffnessOfTheSkeletonAndItsWater) {
  const scene::Scene dry = sand();
  scene::Scene wet = dry;
  wet.mutable_water()->set_bulk_modulus(80e6);
  EXPECT_TRUE(fill_pores(wet).empty());
  EXPECT_NEAR(bulk(wet.material()), bulk(dry.material()) + 80e6 / 0.4, 1e-6 * bulk(dry.material()));
  EXPECT_NEAR(shear(wet.material()), shear(dry.material()), 1e-12 * shear(dry.material()));
  EXPECT_EQ(wet.material().density(), 2000);
  EXPECT_NO_THROW(read_model(wet));
}

TEST(WetGround, TakesNoStifferWaterThanCellsCan) {
  scene::Scene wet = sand();
  wet.mutable_water()->set_bulk_modulus(2.2e9);
  EXPECT_THAT(fill_pores(wet), testing::ElementsAre(testing::HasSubstr("cells take water of at most")));
  EXPECT_DOUBLE_EQ(wet.material().poisson_ratio(), 0.45);
  EXPECT_NEAR(shear(wet.material()), 100e6, 1);
}

TEST(WetGround, WaterThatDrainsAtOnceWeighsOnly) {
  scene::Scene wet = sand();
  EXPECT_TRUE(fill_pores(wet).empty());
  EXPECT_EQ(wet.material().young_modulus(), 260e6);
  EXPECT_EQ(wet.material().density(), 2000);
}

// 20 m below the sea bed of 2,000 kg/m^3, whose level is 11 m: k0 is that of the effective stress.
TEST(WetGround, BearsTheTotalStress) {
  scene::Scene scene = sand();
  auto& layer = *scene.mutable_initial_stress()->add_layers();
  layer.set_bottom(-100);
  layer.set_density(2000);
  layer.set_k0(0.5);
  scene.mutable_initial_stress()->set_surface(1);
  const double g = protocol::kStandardGravity, pressure = 1000 * g * 30, total = g * (2000 * 20 + 1000 * 10);
  const auto stress = stated_stress(scene)(0, -19);
  EXPECT_NEAR(stress.yy, -total, 1e-6);
  EXPECT_NEAR(stress.xx, -(total - pressure) / 2 - pressure, 1e-6);
  scene.mutable_material()->clear_pores();  // tight ground below the same sea
  const auto tight = stated_stress(scene)(0, -19);
  EXPECT_NEAR(tight.yy, -total, 1e-6);
  EXPECT_NEAR(tight.xx, -total / 2, 1e-6);
}

TEST(WetGround, RefusesWhatItDoesNotCompute) {
  scene::Scene discs = sand();
  discs.mutable_particles()->clear_cells();
  test::set_box(*discs.mutable_particles()->mutable_square_packing(), 2, 1);
  discs.mutable_particles()->mutable_square_packing()->set_radius(0.05);
  adit::test::expect_refusal([&] { compute(discs); }, "material.pores", "pack `cells`");

  scene::Scene high = sand();
  high.mutable_water()->set_level(0.5);
  adit::test::expect_refusal([&] { compute(high); }, "material.pores", "above the water");

  scene::Scene wells = sand();
  auto& place = *wells.mutable_water()->add_places();
  place.mutable_where()->set_x_max(0.5);
  place.set_level(2);
  adit::test::expect_refusal([&] { compute(wells); }, "water.places[0].where", "one level of water");

  scene::Scene plate = sand();
  plate.set_plane(scene::PLANE_STRESS);
  adit::test::expect_refusal([&] { compute(plate); }, "water", "plane strain only");
}

}  // namespace
}  // namespace adit::dem::wet_ground_test
