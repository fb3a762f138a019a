// Ground that two models describe differently at one place must be told.
#include "coupler/check/warnings.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <spdlog/fmt/fmt.h>

#include "tests/support/local_participants.hpp"

namespace adit::coupler::compare_ground_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kBlock = "block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 }";
const std::string kSoft = "material { young_modulus: 1e8 poisson_ratio: 0.2 density: 2000 }";
const std::string kLight = "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 1800 }";

// The mesh of kBlock with the zones to the right of x = 2 m in a group of their own.
std::string mesh_with_group() {
  std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"right\"\n$EndPhysicalNames\n"
      "$Entities\n0 0 2 0\n1 0 0 0 2 1 0 0 0\n2 2 0 0 4 1 0 1 1 0\n$EndEntities\n$Nodes\n1 27 1 27\n2 1 0 "
      "27\n";
  for (int node = 1; node <= 27; ++node) text += fmt::format("{}\n", node);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 9; ++column) text += fmt::format("{} {} 0\n", 0.5 * column, 0.5 * row);
  text += "$EndNodes\n$Elements\n2 16 1 16\n";
  int element = 0;
  for (int half = 0; half < 2; ++half) {
    text += fmt::format("2 {} 3 8\n", half + 1);
    for (int row = 0; row < 2; ++row)
      for (int column = 4 * half; column < 4 * half + 4; ++column) {
        const int node = 9 * row + column + 1;
        text += fmt::format("{} {} {} {} {}\n", ++element, node, node + 1, node + 10, node + 9);
      }
  }
  return text + "$EndElements\n";
}

// A bar of 4 m, overlap from 1 m to 2 m, particles in place of the zones beyond.
std::vector<std::string> warnings(const std::string& continuum, const std::string& particles = "") {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } "
      "time { duration: 0.01 } continuum { " +
          continuum + " } particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.1 } " +
          particles +
          " } interface { overlap { particles_begin { x: 1 y: 0 } continuum_ends { x: 2 y: 0 } } }",
      &scene));
  if (scene.continuum().has_mesh()) scene.mutable_continuum()->mutable_mesh()->set_content(mesh_with_group());
  Model model = test::local_model(scene);
  compare_ground(model);
  return model.warnings;
}

// Requirement: where both models overlap they have the same stiffness and density within 5 %, or a warning
// names the place, both values, and where they are stated.
TEST(CompareGround, InAnOverlap) {
  EXPECT_THAT(warnings(kBlock), IsEmpty());
  EXPECT_THAT(warnings(kBlock + "materials { where { x_min: 0.5 x_max: 1.5 } " + kSoft + " }"),
              ElementsAre(AllOf(HasSubstr("interface.overlap lies at ("),
                                HasSubstr("0.1 GPa and 2000 kg/m^3 of `continuum` (continuum.materials[0])"),
                                HasSubstr("1 GPa and 2000 kg/m^3 of `particles` (material)"))));
  EXPECT_THAT(warnings(kBlock + kLight),
              ElementsAre(HasSubstr("1800 kg/m^3 of `continuum` (continuum.material)")));
  EXPECT_THAT(warnings(kBlock, kLight),
              ElementsAre(HasSubstr("1800 kg/m^3 of `particles` (particles.material)")));
  EXPECT_THAT(warnings(kBlock + kSoft, kSoft), IsEmpty());
}

// Requirement: particles that state no material must not replace zones of another; what they state is meant.
TEST(CompareGround, InTheCoreOfAnOverlap) {
  const std::string core = "materials { where { x_min: 3 } " + kSoft + " }";
  EXPECT_THAT(warnings(kBlock + core),
              ElementsAre(AllOf(HasSubstr("1 GPa and 2000 kg/m^3 of `particles` (material) stands at ("),
                                HasSubstr("in place of 0.1 GPa and 2000 kg/m^3 of `continuum`"))));
  EXPECT_THAT(warnings(kBlock + core, "groups { name: 'end' where { x_min: 2.9 } " + kSoft + " }"),
              IsEmpty());
  EXPECT_THAT(warnings(kBlock + core, "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }"),
              IsEmpty());
}

// Requirement: blocks by name are compared like any place.
TEST(CompareGround, OfABlockByItsName) {
  const auto block = [](double from, double to, const std::string& name) {
    return fmt::format(
        "blocks {{ name: '{}' rectangle {{ x_min: {} x_max: {} y_min: 0 y_max: 1 }} along {{ zones: 4 }} "
        "across {{ "
        "zones: 2 }} }}",
        name, from, to);
  };
  const std::string blocks = block(0, 2, "left") + block(2, 4, "right");
  EXPECT_THAT(warnings(blocks + "materials { where { group: 'right' } " + kSoft + " }"),
              ElementsAre(HasSubstr("stands at (")));
  EXPECT_THAT(warnings(blocks + "materials { where { group: 'left' } " + kSoft + " }", kSoft), IsEmpty());
}

// Requirement: where a mesh names the zones, its own drawing tells their place.
TEST(CompareGround, OfAGroupOfAMesh) {
  const std::string mesh = "mesh { path: 'bar.msh' } ";
  EXPECT_THAT(warnings(mesh + "materials { where { group: 'right' } " + kSoft + " }"), IsEmpty());
  const std::string wall =
      "linings { name: 'wall' along { line { points { x: 0 y: 0.5 } points { x: 0.5 y: 0.5 } } } "
      "young_modulus: 3e10 thickness: 0.1 density: 2400 } ";
  EXPECT_THAT(warnings(mesh + wall + "materials { where { group: 'right' } " + kSoft + " }"), IsEmpty())
      << "a drawing of a lining names no ground";
  EXPECT_THAT(warnings(mesh + kSoft + "materials { where { group: 'right' } " + kLight + " }"),
              ElementsAre(HasSubstr("0.1 GPa and 2000 kg/m^3 of `continuum` (continuum.material)")));
}

// Requirement: ground counts with its factors, also where a mesh names its zones.
TEST(CompareGround, OfScatteredModels) {
  const std::string field = "scatter { path: 'field.csv' content: 'x_m,y_m,factor\\n0,0,1\\n4,0,3\\n' } ";
  const std::string right = "mesh { path: 'bar.msh' } materials { where { group: 'right' } " + kSoft + " } ",
                    soft = "groups { name: 'soft' where { x_min: 2 } " + kSoft + " } ";
  for (const auto& [zones, particles] : {std::pair{kBlock, std::string()}, {right, soft}}) {
    EXPECT_THAT(warnings(zones + field, particles),
                ElementsAre(HasSubstr("GPa and 2000 kg/m^3 of `particles`")));
    EXPECT_THAT(warnings(zones + field, particles + field), IsEmpty());
  }
}

// Requirement: particles that have the shear modulus of ground beyond their Poisson's ratios are like it, and
// stiffnesses that bonds state themselves are not compared.
TEST(CompareGround, WhatBondsCannotHave) {
  EXPECT_THAT(warnings(kBlock + "material { young_modulus: 1.45e9 poisson_ratio: 0.45 density: 2000 }",
                       "material { young_modulus: 1.2e9 poisson_ratio: 0.2 density: 2000 }"),
              IsEmpty());
  EXPECT_THAT(warnings(kBlock + kSoft, "bonds { normal_stiffness: 1e8 shear_stiffness: 1e8 }"), IsEmpty());
}

}  // namespace
}  // namespace adit::coupler::compare_ground_test
