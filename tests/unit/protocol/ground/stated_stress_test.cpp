// Requirement: the stress that the scene states is the same for everyone who asks, and what makes no sense is
// refused by name.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "protocol/ground/stated_stress.hpp"
#include "protocol/ground/water_at_rest.hpp"
#include "tests/support/refusals.hpp"

namespace adit::protocol::stated_stress_test {
namespace {

scene::Stress parse(const std::string& text) {
  scene::Stress stress;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &stress)) << text;
  return stress;
}

TEST(StatedStress, GrowsLinearlyWithHeight) {
  const StatedStress stated(parse("xx: -1e3 yy: -2e3 xy: 5e2 xx_per_metre: 10 yy_per_metre: 20"));
  const GroundStress s = stated.at(0, -3);
  EXPECT_DOUBLE_EQ(s.xx, -1030);
  EXPECT_DOUBLE_EQ(s.yy, -2060);
  EXPECT_DOUBLE_EQ(s.xy, 500);
  EXPECT_FALSE(s.zz);
  EXPECT_DOUBLE_EQ(*StatedStress(parse("zz: -4e3 zz_per_metre: 1")).at(0, 2).zz, -3998);
}

// Two layers under a surcharge: the pressure goes on from one to the other, the ratio of the horizontal one
// changes at once, and below the last side the last layer goes on.
TEST(StatedStress, IsTheWeightOfLayers) {
  const StatedStress stated(
      parse("surface: 4 surcharge: 1e4 layers { bottom: 0 density: 2000 k0: 0.5 } "
            "layers { bottom: -10 density: 2500 k0: 0.8 }"));
  const double upper = 2000 * kStandardGravity, lower = 2500 * kStandardGravity;
  EXPECT_NEAR(stated.at(0, 4).yy, -1e4, 1e-6);
  EXPECT_NEAR(stated.at(0, 9).yy, -1e4, 1e-6);
  EXPECT_NEAR(stated.at(0, 1).yy, -1e4 - 3 * upper, 1e-6);
  EXPECT_NEAR(stated.at(0, 1).xx, 0.5 * (-1e4 - 3 * upper), 1e-6);
  EXPECT_NEAR(*stated.at(0, 1).zz, 0.5 * (-1e4 - 3 * upper), 1e-6);
  EXPECT_NEAR(stated.at(0, -12).yy, -1e4 - 4 * upper - 12 * lower, 1e-6);
  EXPECT_NEAR(stated.at(0, -12).xx, 0.8 * stated.at(0, -12).yy, 1e-6);
  EXPECT_NEAR(stated.at(0, 1e-9).yy, stated.at(0, -1e-9).yy, 1e-3);
  EXPECT_NEAR(stated.at(0, 0).xx, 0.5 * stated.at(0, 0).yy, 1e-6) << "the upper layer ends here";
  EXPECT_EQ(stated.at(0, 1).xy, 0);
}

// Below a slope each place bears what stands above it; layers end at the line; beyond its ends the line is
// level, and a level line is the surface.
TEST(StatedStress, IsTheWeightBelowALine) {
  const std::string layers =
      "surcharge: 1e4 layers { bottom: 0 density: 2000 k0: 0.5 } layers { bottom: -10 density: 2500 k0: 0.8 "
      "} ";
  const StatedStress slope(parse(
      "surface_line { x: 0 y: 4 } surface_line { x: 10 y: -6 } surface_line { x: 20 y: -6 } " + layers));
  const double upper = 2000 * kStandardGravity, lower = 2500 * kStandardGravity;
  EXPECT_NEAR(slope.at(-5, -1).yy, -1e4 - 4 * upper - lower, 1e-6);
  EXPECT_NEAR(slope.at(2, 1).yy, -1e4 - upper, 1e-6);
  EXPECT_NEAR(slope.at(2, 1).xx, 0.5 * (-1e4 - upper), 1e-6);
  EXPECT_NEAR(slope.at(2, -1).yy, -1e4 - 2 * upper - lower, 1e-6);
  EXPECT_NEAR(slope.at(6, -3).yy, -1e4 - lower, 1e-6) << "the upper layer is gone here";
  EXPECT_NEAR(slope.at(6, -3).xx, 0.8 * (-1e4 - lower), 1e-6);
  EXPECT_NEAR(*slope.at(30, -12).zz, 0.8 * (-1e4 - 6 * lower), 1e-6) << "the last layer goes on";
  EXPECT_NEAR(slope.at(30, 3).yy, -1e4, 1e-6) << "above the ground";
  const StatedStress level(parse("surface_line { x: 0 y: 4 } surface_line { x: 10 y: 4 } " + layers));
  const StatedStress surface(parse("surface: 4 " + layers));
  for (const double y : {9., 3.9, 0.1, -0.1, -9., -15.}) {
    EXPECT_NEAR(level.at(3, y).yy, surface.at(3, y).yy, 1e-6) << y;
    EXPECT_NEAR(level.at(3, y).xx, surface.at(3, y).xx, 1e-6) << y;
  }
}

// k0 is that of effective stresses where the pores hold water, and the sea weighs on the ground without
// changing them; components are what is stated.
TEST(StatedStress, HoldsTheWater) {
  scene::Water water;
  water.set_level(12);
  const scene::Stress layer = parse("surface: 4 layers { bottom: -10 density: 2000 k0: 0.5 }");
  const StatedStress below_sea(layer, &water), dry(layer);
  const double sea = pressure_at_rest(water, 12, 4), pore = pressure_at_rest(water, 12, -1);
  EXPECT_NEAR(sea, 8 * 1000 * kStandardGravity, 1e-6);
  const GroundStress wet = below_sea.at(0, -1, pore);
  EXPECT_NEAR(wet.yy, dry.at(0, -1).yy - sea, 1e-6);
  EXPECT_NEAR(wet.xx + pore, (wet.yy + pore) / 2, 1e-6);
  EXPECT_NEAR(*wet.zz + pore, (wet.yy + pore) / 2, 1e-6);
  EXPECT_NEAR(below_sea.at(0, -1).xx, below_sea.at(0, -1).yy / 2, 1e-6) << "tight ground under the sea";
  EXPECT_DOUBLE_EQ(StatedStress(parse("xx: -1e3 yy: -2e3"), &water).at(0, 0, 500).xx, -1e3);
}

// The sea is deeper above the lower parts of a slope, and ends where the slope rises out of it.
TEST(StatedStress, BearsTheSeaAboveASlope) {
  scene::Water water;
  water.set_level(2);
  const StatedStress slope(parse("surface_line { x: 0 y: 4 } surface_line { x: 8 y: -4 } "
                                 "layers { bottom: -10 density: 2000 k0: 0.5 }"),
                           &water);
  const double ground = 2000 * kStandardGravity, sea = 1000 * kStandardGravity;
  EXPECT_NEAR(slope.at(1, 1).yy, -2 * ground, 1e-6) << "above the sea";
  EXPECT_NEAR(slope.at(4, -3).yy, -(2 * sea + 3 * ground), 1e-6);
  const double pore = pressure_at_rest(water, 2, -6);
  const GroundStress foot = slope.at(12, -6, pore);
  EXPECT_NEAR(foot.yy, -(6 * sea + 2 * ground), 1e-6);
  EXPECT_NEAR(foot.xx + pore, (foot.yy + pore) / 2, 1e-6);
}

// A place that has a level of its own from the beginning on changes what stands on the ground there.
TEST(StatedStress, BearsTheSeaOfEachPlace) {
  scene::Water water;
  water.set_level(5);
  scene::WaterPlace& place = *water.add_places();
  place.mutable_where()->set_x_max(10);
  place.set_level(-4);
  const StatedStress stated(parse("surface: 0 layers { bottom: -10 density: 2000 k0: 0.5 }"), &water);
  const double ground = 2000 * kStandardGravity, sea = 1000 * kStandardGravity;
  EXPECT_NEAR(stated.at(3, -6).yy, -6 * ground, 1e-6);
  EXPECT_NEAR(stated.at(12, -6).yy, -(5 * sea + 6 * ground), 1e-6);
}

TEST(StatedStress, RefusesWhatContradictsItself) {
  const std::string layer = "layers { bottom: -1 density: 2000 k0: 0.5 } ";
  const auto refuse = [](const std::string& text, const std::string& path, const std::string& says) {
    test::expect_refusal([&] { StatedStress stated(parse(text)); }, path, says);
  };
  refuse(layer + "xx: -1e3", "initial_stress.layers", "beside components");
  refuse(layer + "layers { bottom: -1 density: 2000 k0: 1 }", "initial_stress.layers[1].bottom",
         "is -1 m, not below the layer above");
  refuse("surface: -2 " + layer, "initial_stress.layers[0].bottom", "not below the surface");
  refuse("xx: -1e3 surface: 3", "initial_stress.surface", "without layers");
  refuse("xx: -1e3 surcharge: 3", "initial_stress.surcharge", "without layers");
  const std::string line = "surface_line { x: 0 y: 4 } ";
  refuse("xx: -1e3 " + line, "initial_stress.surface_line", "without layers");
  refuse("surface: 3 " + line + layer, "initial_stress.surface_line", "beside `surface`");
  refuse(line + line + layer, "initial_stress.surface_line[1].x", "not right of the point before");
}

}  // namespace
}  // namespace adit::protocol::stated_stress_test
