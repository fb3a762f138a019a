// The forms that a scene file may have, and the scene that the programs then read.
#include "protocol/scene/reader.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "protocol/scene/hash.hpp"
#include "protocol/scene/writer.hpp"
#include "tests/unit/protocol/scene/scene_files.hpp"

namespace adit::protocol::reader_test {
namespace {

using testing::ScratchFolder;

// The continuum goes on.
const std::string kTwoZones =
    "material: {young_modulus: 1 GPa, poisson_ratio: 0.2, density: 1 t/m^3}\ntime: {duration: 1 s}\n"
    "continuum:\n"
    "  block: {x_min: 0, x_max: 1, y_min: 0, y_max: 1, zones_x: 1, zones_y: 2}\n";

const std::string kBeam = R"(plane: plane_stress
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}
time: {duration: 50 ms}
particles:
  packing: {x_min: 0, x_max: 10 m, y_min: 0, y_max: 1 m, radius: 6 cm}
  bonds: {tensile_strength: inf, shear_strength: 8 MN}
  loads:
    - where: {x_max: 0.065 m}
      force: {y: 5 MN}
      time: {sine: {frequency: 50 Hz, phase: 90 deg, end: 10 ms}}
    - where: {x_min: 9 m}
      force: {x: 1 kN}
      time: {table: {time: [0, 10 ms, 0.5], value: [0, 1, 1]}}
  histories:
    - {name: tip, quantity: displacement_y, at: {x: 0 m, y: 0.5 m}}
output:
  field_times: [20 ms, 0.024]
)";

scene::Scene read(const ScratchFolder& folder, const std::string& name,
                  const std::vector<std::string>& sets = {}) {
  return read_scene(folder.path(name), parse_overrides(sets)).scene;
}

TEST(SceneReader, EveryKindOfFieldIsRead) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  const scene::Scene scene = read(folder, "beam.yaml");
  EXPECT_EQ(scene.name(), "beam");
  EXPECT_EQ(scene.plane(), scene::PLANE_STRESS);
  EXPECT_EQ(scene.material().young_modulus(), 25e9);
  EXPECT_EQ(scene.material().density(), 2500);
  EXPECT_EQ(scene.particles().packing().radius(), 0.06);
  EXPECT_TRUE(std::isinf(scene.particles().bonds().tensile_strength()));
  EXPECT_EQ(scene.particles().bonds().shear_strength(), 8e6);
  ASSERT_EQ(scene.particles().loads_size(), 2);
  EXPECT_EQ(scene.particles().loads(0).time().sine().end(), 0.01);
  EXPECT_DOUBLE_EQ(scene.particles().loads(0).time().sine().phase(), std::acos(0.0));
  EXPECT_THAT(scene.particles().loads(1).time().table().time(), ::testing::ElementsAre(0, 0.01, 0.5));
  EXPECT_EQ(scene.particles().histories(0).quantity(), scene::DISPLACEMENT_Y);
  EXPECT_EQ(scene.particles().histories(0).name(), "tip");
  EXPECT_THAT(scene.output().field_times(), ::testing::ElementsAre(0.02, 0.024));
}

TEST(SceneReader, WhatIsNotGivenStaysUnsetAndHasItsDefault) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  const scene::Scene scene = read(folder, "beam.yaml");
  EXPECT_FALSE(scene.time().has_dt_factor());
  EXPECT_EQ(scene.time().dt_factor(), 0.5);
  EXPECT_FALSE(scene.has_continuum());
  EXPECT_FALSE(scene.particles().loads(0).where().has_x_min());
}

TEST(SceneReader, AMappingIsMergedKeyByKeyAndAListReplacesThatOfTheExtendedFile) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  folder.write("soft.yaml", "extends: beam.yaml\nmaterial: {young_modulus: 1 GPa}\nparticles: {loads: []}\n");
  const scene::Scene scene = read(folder, "soft.yaml");
  EXPECT_EQ(scene.material().young_modulus(), 1e9);
  EXPECT_EQ(scene.material().poisson_ratio(), 0.2);
  EXPECT_EQ(scene.particles().loads_size(), 0);
  EXPECT_EQ(scene.particles().histories_size(), 1);
  EXPECT_EQ(scene.name(), "soft");
}

TEST(SceneReader, ExtendedFilesAreRelativeToTheFileThatNamesThemAndMayExtendOthers) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("deep"));
  folder.write("beam.yaml", "name: beam\n" + kBeam);
  folder.write("deep/middle.yaml", "extends: ../beam.yaml\nmaterial: {poisson_ratio: 0.3}\n");
  folder.write("top.yaml", "extends: deep/middle.yaml\nmaterial: {density: 1 t/m^3}\n");
  const scene::Scene scene = read(folder, "top.yaml");
  EXPECT_EQ(scene.material().young_modulus(), 25e9);
  EXPECT_EQ(scene.material().poisson_ratio(), 0.3);
  EXPECT_EQ(scene.material().density(), 1000);
  EXPECT_EQ(scene.name(), "top");  // else both would write into one results' folder
  EXPECT_EQ(read(folder, "beam.yaml").name(), "beam");
}

// The word of older scenes is read, with one warning that says what to write.
TEST(SceneReader, BaseIsTheFormerWordForExtends) {
  const ScratchFolder folder;
  const std::string beam = folder.write("beam.yaml", kBeam);
  const std::string old = folder.write("old.yaml", "base: beam.yaml\nmaterial: {poisson_ratio: 0.3}\n");
  const SceneFile file = read_scene(old);
  EXPECT_EQ(file.scene.material().poisson_ratio(), 0.3);
  EXPECT_EQ(file.scene.extends(), "beam.yaml");
  EXPECT_THAT(file.warnings, ::testing::ElementsAre(
                                 old + ":1:1: base: is now called `extends`; write `extends: beam.yaml`"));
  EXPECT_THAT(read_scene(beam).warnings, ::testing::IsEmpty());
}

// Required fields may come from the extended file or from the command line.
TEST(SceneReader, RequiredFieldsAreCheckedAfterMerging) {
  const ScratchFolder folder;
  folder.write("base.yaml", "material: {young_modulus: 1 GPa, poisson_ratio: 0.2}\n");
  folder.write("x.yaml", "extends: base.yaml\ntime: {duration: 1 s}\n");
  EXPECT_EQ(read(folder, "x.yaml", {"material.density=2 t/m^3"}).material().density(), 2000);
}

TEST(SceneReader, OfAlternativesTheLaterLayerWins) {
  const ScratchFolder folder;
  folder.write("base.yaml", kTwoZones +
                                "  point_loads:\n"
                                "    - {where: {}, force: {x: 1}, time: {constant: 3}}\n");
  EXPECT_EQ(read(folder, "base.yaml").continuum().point_loads(0).time().constant(), 3);
  const auto time = read(folder, "base.yaml", {"continuum.point_loads[0].time.sine.frequency=2 Hz"})
                        .continuum()
                        .point_loads(0)
                        .time();
  EXPECT_EQ(time.shape_case(), scene::TimeFunction::kSine);
  EXPECT_EQ(time.sine().frequency(), 2);
}

// `null` takes away what the extended scene gives, whatever its kind; so does `--set`.
TEST(SceneReader, NullTakesAwayWhatTheExtendedFileGives) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  folder.write("free.yaml",
               "extends: beam.yaml\nparticles:\n  bonds: {tensile_strength: ~}\n  loads: null\noutput: ~\n");
  for (const scene::Scene& scene :
       {read(folder, "free.yaml"),
        read(folder, "beam.yaml",
             {"particles.bonds.tensile_strength=~", "particles.loads=null", "output=null"})}) {
    EXPECT_FALSE(scene.particles().bonds().has_tensile_strength());
    EXPECT_EQ(scene.particles().bonds().shear_strength(), 8e6);
    EXPECT_EQ(scene.particles().loads_size(), 0);
    EXPECT_FALSE(scene.has_output());
  }
  const scene::Scene one = read(folder, "beam.yaml", {"particles.loads.0=~"});
  ASSERT_EQ(one.particles().loads_size(), 1);
  EXPECT_EQ(one.particles().loads(0).force().x(), 1e3);
}

// A kind of motion takes the place of another one, also where that is taken away in the same breath.
TEST(SceneReader, AlternativesReplaceThoseOfTheExtendedFile) {
  const ScratchFolder folder;
  folder.write("base.yaml",
               kTwoZones + "  base: {kind: rigid, acceleration: {file: {path: record.csv}, peak: 0.1 g}}\n");
  for (const std::string taken : {"", "file: ~, "}) {
    folder.write("x.yaml", "extends: base.yaml\ncontinuum: {base: {acceleration: {" + taken +
                               "ricker: {frequency: 2 Hz, time: 1 s}}}}\n");
    const auto motion = read(folder, "x.yaml").continuum().base().acceleration();
    EXPECT_EQ(motion.source_case(), scene::GroundMotion::kRicker) << taken;
    EXPECT_DOUBLE_EQ(motion.peak(), 0.980665);
  }
}

// A value that is written once stands wherever its name is given; a mapping takes members of others by `<<`.
TEST(SceneReader, AliasesRepeatValuesAndMappingsTakeMembersOfOthers) {
  const ScratchFolder folder;
  folder.write("plain.yaml", kBeam);
  std::string text = kBeam;
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("time: {duration: 50 ms}", "time: {duration: &end 50 ms}");
  replace("    - where: {x_max: 0.065 m}\n      force: {y: 5 MN}",
          "    - &load\n      where: {x_max: 0.065 m}\n      force: {y: 5 MN}");
  replace("    - where: {x_min: 9 m}\n", "    - <<: *load\n      where: {x_min: 9 m}\n");
  replace("[20 ms, 0.024]", "[20 ms, *end]");
  folder.write("named.yaml", text);
  const scene::Scene scene = read(folder, "named.yaml");
  EXPECT_THAT(scene.output().field_times(), ::testing::ElementsAre(0.02, 0.05));
  scene::Scene expected = read(folder, "plain.yaml", {"output.field_times[1]=50 ms", "name=named"});
  EXPECT_EQ(scene.DebugString(), expected.DebugString());  // where, force and time are its own
  folder.write("motion.yaml",
               "extends: plain.yaml\nparticles:\n  loads:\n"
               "    - &a {where: {x_max: 1 m}, force: {x: 1 N}}\n"
               "    - &b {where: {x_max: 2 m}, force: {y: 1 N}, time: {constant: 2}}\n"
               "    - {<<: [*b, *a], where: {x_max: 3 m}}\n");
  const auto merged = read(folder, "motion.yaml").particles().loads(2);
  EXPECT_EQ(merged.where().x_max(), 3);
  EXPECT_FALSE(merged.force().has_x());  // members are taken whole, from the first that has them
  EXPECT_EQ(merged.force().y(), 1);
  EXPECT_EQ(merged.time().constant(), 2);
}

// Mappings have no order: keys in any order, also those of files that extend others, give the same scene.
TEST(SceneReader, KeysInAnyOrderGiveTheSameScene) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  const std::string forward =
      "extends: beam.yaml\nparticles:\n  bonds: {tensile_strength: ~, shear_strength: 1 MN}\n"
      "  loads:\n    - {where: {x_max: 1}, force: {x: 1, y: 2}, time: {constant: 1}}\n"
      "plane: plane_strain\nname: x\n";
  const std::string backward =
      "name: x\nplane: plane_strain\nparticles:\n"
      "  loads:\n    - {time: {constant: 1}, force: {y: 2, x: 1}, where: {x_max: 1}}\n"
      "  bonds: {shear_strength: 1 MN, tensile_strength: ~}\nextends: beam.yaml\n";
  folder.write("forward.yaml", forward);
  folder.write("backward.yaml", backward);
  EXPECT_EQ(read(folder, "forward.yaml").SerializeAsString(),
            read(folder, "backward.yaml").SerializeAsString());
}

TEST(SceneReader, SetsReplaceFieldsElementsAndWholeMappingsInTheirOrder) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  const scene::Scene scene = read(
      folder, "beam.yaml",
      {"particles.loads[0].force.y=1 MN", "particles.loads[0].force.y=-2 MN", "interface.weight_floor=0.01",
       "interface.overlap={particles_begin: {x: 4, y: 0}, continuum_ends: {x: 6 m, y: 0}}",
       "particles.bonds={tensile_strength: 10 MN}", "output.field_times=[1 ms, 2 ms]",
       "output.field_times[1]=3 ms", "description=other = one"});
  EXPECT_EQ(scene.particles().loads(0).force().y(), -2e6);
  EXPECT_EQ(scene.particles().loads(0).time().sine().frequency(), 50);
  EXPECT_EQ(scene.interface().weight_floor(), 0.01);
  EXPECT_EQ(scene.interface().overlap().continuum_ends().x(), 6);
  EXPECT_EQ(scene.particles().bonds().tensile_strength(), 10e6);
  EXPECT_FALSE(scene.particles().bonds().has_shear_strength());
  EXPECT_THAT(scene.output().field_times(), ::testing::ElementsAre(0.001, 0.003));
  EXPECT_EQ(scene.description(), "other = one");
}

// Errors that are found after reading are reported where the field, or what holds it, was written.
TEST(SceneReader, FieldsAreLocatedInTheFileThatGaveThem) {
  const ScratchFolder folder;
  const std::string beam = folder.write("beam.yaml", kBeam);
  const std::string top =
      folder.write("top.yaml", "extends: beam.yaml\n\nparticles:\n  bonds: {shear_strength: 1 N}\n");
  const SceneFile file =
      read_scene(top, parse_overrides(std::vector<std::string>{"particles.bonds.tensile_strength=1 MN"}));
  EXPECT_EQ(file.locate("particles.loads[0].where"), beam + ":8:7");
  EXPECT_EQ(file.locate("particles.loads[0].where.x_min"), beam + ":8:7");
  EXPECT_EQ(file.locate("particles.loads[1]"), beam + ":11:7");
  EXPECT_EQ(file.locate("particles.loads[7].where"), beam + ":7:3");
  EXPECT_EQ(file.locate("output.field_times[1]"), beam + ":17:24");
  EXPECT_EQ(file.locate("particles.bonds.shear_strength"), top + ":4:11");
  EXPECT_EQ(file.locate("particles.bonds.tensile_strength"), "--set particles.bonds.tensile_strength=1 MN");
  EXPECT_EQ(file.locate("interface.overlap"), top + ":1:1");
  EXPECT_EQ(file.locate(""), top + ":1:1");
  EXPECT_EQ(file.locate("]no.[path"), top + ":1:1");
  EXPECT_EQ(describe(file, UserError("particles.loads[0].where", "selects no particles")),
            beam + ":8:7: particles.loads[0].where: selects no particles");
  EXPECT_EQ(describe(file, UserError("", "nothing listens there")), "nothing listens there");
}

// What a run directory keeps of the scene is the scene.
TEST(SceneReader, AWrittenSceneReadsBackAsTheSameMessage) {
  const ScratchFolder folder;
  folder.write("beam.yaml", kBeam);
  const scene::Scene scene = read(folder, "beam.yaml");
  folder.write("again.yaml", to_yaml(scene));
  const scene::Scene again = read(folder, "again.yaml");
  EXPECT_EQ(again.SerializeAsString(), scene.SerializeAsString());
  EXPECT_EQ(scene_hash(again), scene_hash(scene));
}

}  // namespace
}  // namespace adit::protocol::reader_test
