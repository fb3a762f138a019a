// A class of concrete stands for what a material does not state itself.
#include "protocol/scene/fill_in_concrete.hpp"

#include <gmock/gmock.h>

#include "protocol/materials/concrete.hpp"
#include "tests/unit/protocol/scene/scene_files.hpp"

namespace adit::protocol::fill_in_concrete_test {
namespace {

using testing::complaint_about;
using testing::ScratchFolder;

constexpr const char* kCells = "particles: {cells: {x_min: 0, x_max: 1, y_min: 0, y_max: 1, size: 0.1}}\n";
constexpr const char* kDiscs =
    "particles: {packing: {x_min: 0, x_max: 1, y_min: 0, y_max: 1, radius: 0.1}}\n";
constexpr const char* kGrid =
    "continuum: {block: {x_min: 0, x_max: 1, y_min: 0, y_max: 1, zones_x: 2, zones_y: 2}}\n";

scene::Scene read(const std::string& text) {
  const ScratchFolder folder;
  folder.write("x.yaml", "time: {duration: 1}\n" + text);
  return read_scene(folder.path("x.yaml")).scene;
}

TEST(FillInConcrete, StatesAllOfAMaterialOfCells) {
  const auto material = read("material: {concrete: C30/37}\n" + std::string(kCells)).material();
  const Concrete concrete = *concrete_of("C30/37");
  EXPECT_FALSE(material.has_concrete());
  EXPECT_EQ(material.young_modulus(), concrete.young_modulus);
  EXPECT_EQ(material.poisson_ratio(), 0.2);
  EXPECT_EQ(material.density(), 2400);
  EXPECT_EQ(material.fracture().tensile_strength(), concrete.tensile_strength);
  EXPECT_EQ(material.fracture().compressive_strength(), concrete.compressive_strength);
  EXPECT_EQ(material.fracture().fracture_energy(), concrete.fracture_energy);
}

// Zones compare their stress with the strength; discs have no use for it.
TEST(FillInConcrete, IsElasticForDiscsOnly) {
  for (const auto& [model, breaks] : {std::pair{kDiscs, false}, std::pair{kGrid, true}}) {
    const auto material = read(std::string("material: {concrete: C30}\n") + model).material();
    EXPECT_EQ(material.young_modulus(), 30e9);
    EXPECT_EQ(material.has_fracture(), breaks);
  }
  const auto both = read(
      "material: {concrete: C30}\ncontinuum: {block: {x_min: 0, x_max: 1, y_min: 0, y_max: "
      "1, zones_x: 2, zones_y: 2}, material: {concrete: C20}}\n" +
      std::string(kCells));
  EXPECT_TRUE(both.material().has_fracture());
  EXPECT_TRUE(both.continuum().material().has_fracture());
}

TEST(FillInConcrete, LeavesWhatIsStated) {
  const auto material =
      read(
          "material: {concrete: C30/37, density: 2500, fracture: {fracture_energy: 90, cohesion: "
          "10 MPa}}\n" +
          std::string(kCells))
          .material();
  EXPECT_EQ(material.density(), 2500);
  EXPECT_EQ(material.fracture().fracture_energy(), 90);
  EXPECT_EQ(material.fracture().tensile_strength(), concrete_of("C30/37")->tensile_strength);
  EXPECT_FALSE(material.fracture().has_compressive_strength());  // the cohesion says it
}

TEST(FillInConcrete, WorksInGroupsAndRegions) {
  const auto scene = read(
      "material: {concrete: C20/25}\nregions:\n  - name: a\n    particles:\n      cells: {x_min: 0, x_max: "
      "1, "
      "y_min: 0, y_max: 1, size: 0.1}\n      groups: [{name: b, where: {x_max: 0.5}, material: {concrete: "
      "C50/60}}]\n");
  EXPECT_EQ(scene.regions(0).particles().groups(0).material().fracture().compressive_strength(), 58e6);
  EXPECT_EQ(scene.material().fracture().compressive_strength(), 28e6);
}

TEST(FillInConcrete, WorksInTunnels) {
  const auto lining_of = [](const std::string& grains) {
    return read("material: {concrete: C20/25}\n" + std::string(kGrid) +
                "tunnels:\n  - centre: {x: 0, y: 0}\n    circle: {radius: 3}\n    lining: {thickness: 0.5, "
                "material: {concrete: C50/60}}\n    particles: {ground: 2, overlap: 1, " +
                grains + "}\n")
        .tunnels(0)
        .lining()
        .material();
  };
  EXPECT_EQ(lining_of("size: 0.1").fracture().compressive_strength(), 58e6);
  EXPECT_FALSE(lining_of("radius: 0.05").has_fracture());
}

TEST(FillInConcrete, RefusesClassesThatAreNotKnown) {
  EXPECT_EQ(complaint_about("time: {duration: 1}\nmaterial: {concrete: C30/35}\n"),
            "x.yaml:2:12: material.concrete: is `C30/35`, expected a class of EN 1992-1-1 (`C12/15` to "
            "`C90/105`) or of GB 50010 (`C15` to `C80`); did you mean `C30/37`?");
}

TEST(FillInConcrete, RefusesAClassThatStatesNothing) {
  EXPECT_EQ(
      complaint_about("time: {duration: 1}\nmaterial: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: "
                      "2400, concrete: C30}\n" +
                      std::string(kDiscs)),
      "x.yaml:2:70: material.concrete: states nothing, because the material states all of its numbers "
      "itself; leave it out, or leave out the keys that it shall stand for");
}

}  // namespace
}  // namespace adit::protocol::fill_in_concrete_test
