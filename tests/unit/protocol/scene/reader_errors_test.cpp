// Every error in a scene file is reported in one line: where it is, what was found, what was expected.
#include <gmock/gmock.h>

#include "tests/unit/protocol/scene/scene_files.hpp"

namespace adit::protocol::reader_errors_test {
namespace {

using testing::complaint;
using testing::complaint_about;
using ::testing::HasSubstr;
using testing::ScratchFolder;
using ::testing::StartsWith;

// Lines 1 and 2 of every scene here; what is tested begins in line 3.
const std::string kHead =
    "material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}\n"
    "time: {duration: 50 ms}\n";

std::string about(const std::string& rest, const std::vector<std::string>& sets = {}) {
  return complaint_about(kHead + rest, sets);
}

TEST(SceneErrors, TheHeadAloneIsAccepted) {
  EXPECT_EQ(about(""), "");
}

TEST(SceneErrors, UnknownKeyGetsTheNearestNameAndTheKnownOnes) {
  EXPECT_EQ(
      about("particles:\n  packing:\n    radus: 1 m\n"),
      "x.yaml:5:5: particles.packing.radus: unknown; did you mean `radius`? known here: x_min, x_max, y_min, "
      "y_max, radius, bends_as_solid");
  EXPECT_EQ(
      about("fluid: 3\n"),
      "x.yaml:3:1: fluid: unknown; known here: extends, name, description, plane, material, time, continuum, "
      "particles, interface, output, simplified, regions, interfaces, initial_stress, statics, tunnels, "
      "questions, accuracy, water");
}

TEST(SceneErrors, NumberBeyondItsLimit) {
  const std::string packing = "particles:\n  packing:\n    radius: ";
  EXPECT_EQ(about(packing + "-0.1 m\n"),
            "x.yaml:5:5: particles.packing.radius: is -0.1 m, expected a length above 0 m");
  EXPECT_EQ(about(packing + "-0.1\n"),
            "x.yaml:5:5: particles.packing.radius: is -0.1 m, expected a length above 0 m");
  EXPECT_EQ(about(packing + "0\n"),
            "x.yaml:5:5: particles.packing.radius: is 0 m, expected a length above 0 m");
  EXPECT_EQ(complaint_about("material: {poisson_ratio: 0.5}\n"),
            "x.yaml:1:12: material.poisson_ratio: is 0.5, expected a pure number above -1 and below 0.5");
  EXPECT_EQ(complaint_about("time: {dt_factor: 1.1}\n"),
            "x.yaml:1:8: time.dt_factor: is 1.1, expected a pure number above 0 and at most 1");
  EXPECT_EQ(about("output: {field_times: [0, 10 ms, -1 ms]}\n"),
            "x.yaml:3:34: output.field_times[2]: is -1 ms, expected a time of at least 0 s");
  EXPECT_EQ(about("continuum: {block: {zones_x: 0}}\n"),
            "x.yaml:3:21: continuum.block.zones_x: is 0, expected a whole number above 0");
}

TEST(SceneErrors, UnitOfAnotherDimensionOrUnknown) {
  EXPECT_EQ(complaint_about("material:\n  young_modulus: 30 kg\n"),
            "x.yaml:2:3: material.young_modulus: `30 kg` is a mass; a pressure such as `30 GPa` is expected");
  EXPECT_EQ(complaint_about("material:\n  young_modulus: 30 gpa\n"),
            "x.yaml:2:3: material.young_modulus: unit `gpa` is unknown; did you mean `GPa`?");
  EXPECT_EQ(complaint_about("material:\n  poisson_ratio: 20 ?\n"),
            "x.yaml:2:3: material.poisson_ratio: unit `?` is unknown");
}

TEST(SceneErrors, WhatIsNoNumber) {
  EXPECT_EQ(complaint_about("time: {duration: soon}\n"),
            "x.yaml:1:8: time.duration: `soon` is not a number; a time such as `10 ms` is expected");
  EXPECT_EQ(complaint_about("time: {duration: .nan}\n"),
            "x.yaml:1:8: time.duration: `.nan` is not a number; a time such as `10 ms` is expected");
  EXPECT_EQ(complaint_about("time: {duration: inf}\n"),
            "x.yaml:1:8: time.duration: is infinite, expected a time above 0 s");
  EXPECT_EQ(about("continuum: {block: {zones_x: 4.5}}\n"),
            "x.yaml:3:21: continuum.block.zones_x: is `4.5`, expected a whole number above 0, such as `10`");
  for (const std::string number : {"-4", "4e1", "4294967296", "0x10", "4 m", "''"})
    EXPECT_THAT(about("continuum: {block: {zones_x: " + number + "}}\n"),
                HasSubstr("expected a whole number"))
        << number;
}

TEST(SceneErrors, UnknownEnumerator) {
  EXPECT_EQ(about("plane: plane_stres\n"),
            "x.yaml:3:1: plane: is `plane_stres`, expected one of plane_strain, plane_stress; did you mean "
            "`plane_stress`?");
  EXPECT_EQ(about("plane: 1\n"), "x.yaml:3:1: plane: is `1`, expected one of plane_strain, plane_stress");
  EXPECT_THAT(about("plane: PLANE_STRESS\n"), HasSubstr("did you mean `plane_stress`?"));
}

TEST(SceneErrors, MissingFieldNamesTheMappingAroundItAndWhatToWrite) {
  EXPECT_EQ(complaint_about("description: nothing else\n"),
            "x.yaml:1:1: time: is missing; write for example `time: {duration: 10 ms}`");
  EXPECT_EQ(complaint_about("material:\n  young_modulus: 1 GPa\n  poisson_ratio: 0.2\n"),
            "x.yaml:1:1: material.density: is missing; write for example `density: 2.5 t/m^3`");
  EXPECT_EQ(about("continuum:\n  histories:\n    - name: tip\n"),
            "x.yaml:5:7: continuum.histories[0].quantity: is missing; write for example `quantity: "
            "displacement_x`");
  EXPECT_EQ(
      about("particles: {body_loads: [{acceleration: {}, time: {table: {value: [1]}}}]}\n"),
      "x.yaml:3:52: particles.body_loads[0].time.table.time: is missing; write for example `time: [10 ms]`");
  EXPECT_THAT(about("particles: {body_loads: [{acceleration: {}, time: {table: {value: [1], time: []}}}]}\n"),
              HasSubstr("table.time: is missing"));
}

TEST(SceneErrors, WrongKindOfValue) {
  EXPECT_EQ(about("particles: 5\n"),
            "x.yaml:3:1: particles: is `5`, expected a mapping such as `{packing: {x_min: 0.5 m, x_max: 2 m, "
            "y_min: 0.5 m, y_max: 2 m, radius: 0.5 m}}`");
  EXPECT_EQ(about("output: [1]\n"),
            "x.yaml:3:1: output: is a list, expected a mapping such as "
            "`{history_interval: 10 ms}`");
  EXPECT_EQ(about("output: {field_times: 10 ms}\n"),
            "x.yaml:3:10: output.field_times: is `10 ms`, expected a list such as `[10 ms]`");
  EXPECT_EQ(about("output: {history_interval: [1 ms]}\n"),
            "x.yaml:3:10: output.history_interval: is a list, expected a time above 0 s");
  EXPECT_EQ(about("description: {a: b}\n"), "x.yaml:3:1: description: is a mapping, expected a text");
  EXPECT_THAT(complaint_about("- 1\n- 2\n"),
              StartsWith("x.yaml:1:1: the scene is a list, expected a mapping"));
  EXPECT_THAT(complaint_about("hello\n"), StartsWith("x.yaml:1:1: the scene is `hello`, expected a mapping"));
}

TEST(SceneErrors, NullValuesAreRefused) {
  EXPECT_EQ(about("description:\n"), "x.yaml:3:1: description: is empty, expected a text");
  EXPECT_EQ(about("plane: ~\n"), "x.yaml:3:1: plane: is empty, expected one of plane_strain, plane_stress");
  EXPECT_THAT(about("particles:\n"), StartsWith("x.yaml:3:1: particles: is empty, expected a mapping"));
  EXPECT_THAT(about("output: {field_times: }\n"), HasSubstr("is empty, expected a list"));
  EXPECT_EQ(about("output: {field_times: [1, ~]}\n"),
            "x.yaml:3:27: output.field_times[1]: is empty, expected a time of at least 0 s");
  for (const std::string text : {"", "\n", "# only a comment\n", "---\n", "~\n"})
    EXPECT_THAT(complaint_about(text), HasSubstr("the scene is empty, expected a mapping")) << text;
}

TEST(SceneErrors, TwoAlternativesOfOneChoice) {
  EXPECT_EQ(
      about("continuum:\n  body_loads:\n    - acceleration: {y: -1 g}\n      time:\n        constant: 1\n"
            "        sine: {frequency: 1 Hz}\n"),
      "x.yaml:8:9: continuum.body_loads[0].time.sine: is given beside `constant`; keep one of constant, "
      "table, sine");
}

// A few lines of aliases of aliases, or anchors inside anchors, cannot fill the memory or the stack.
TEST(SceneErrors, AliasesAreLimited) {
  std::string bomb = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (char name = 'b'; name < 'k'; ++name) {
    bomb += std::string(1, name) + ": &" + name + " [";
    for (int i = 0; i < 10; ++i) bomb += std::string(i > 0 ? ", " : "") + "*" + static_cast<char>(name - 1);
    bomb += "]\n";
  }
  EXPECT_THAT(about(bomb), HasSubstr("anchors and aliases (`&name`, `*name`) hold more than 200000 values"));
  std::string nested = "a: ";
  for (int i = 0; i < 30; ++i) nested += "&a" + std::to_string(i) + " [";
  for (int i = 0; i < 20000; ++i) nested += "1,";
  EXPECT_THAT(about(nested + "1" + std::string(30, ']') + "\n"), HasSubstr("hold more than 200000 values"));
  EXPECT_THAT(about("a: &a [[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]\nb: [[[[[[[[[[[[[[*a]]]]]]]]]]]]]]\n"),
              HasSubstr("is nested more than 32"));
  EXPECT_THAT(about("description: &a [*a]\n"), HasSubstr("stands inside the value that it names"));
  EXPECT_THAT(about("description: *a\n"), HasSubstr("is not YAML"));
  EXPECT_THAT(about("output: {<<: 3}\n"), HasSubstr("`<<` takes the members of mappings"));
}

// What cannot be taken away, because nothing is there, is told: the key may be misspelt.
TEST(SceneErrors, OnlyWhatIsGivenCanBeTakenAway) {
  EXPECT_EQ(
      about("", {"continuum.free_field=null"}),
      "--set continuum.free_field=null: continuum: is not given, so that nothing can be taken away; leave "
      "this out");
  EXPECT_THAT(about("output: {field_times: [1 s]}\n", {"output.field_times[1]=~"}),
              HasSubstr("output.field_times[1]: is not given"));
  const ScratchFolder folder;
  folder.write("base.yaml", kHead);
  folder.write("x.yaml", "extends: base.yaml\noutput: ~\n");
  EXPECT_THAT(complaint(folder, "x.yaml"), StartsWith("x.yaml:2:1: output: is empty, expected a mapping"));
  folder.write("x.yaml", "extends: base.yaml\ntime:\n");  // more likely a mistake than a wish
  EXPECT_THAT(complaint(folder, "x.yaml"), StartsWith("x.yaml:2:1: time: is empty, expected a mapping"));
}

TEST(SceneErrors, AListIsNotAMapping) {
  EXPECT_EQ(about("output: {field_times: [1 s]}\n", {"output.field_times.1=2 s"}),
            "--set output.field_times.1=2 s: output.field_times[1]: does not exist; output.field_times has 1 "
            "elements, counted from 0");
  EXPECT_THAT(
      about("particles: {loads: [{force: {y: 1}}]}\n", {"particles.loads.force=2 N"}),
      HasSubstr("particles.loads: is a list; name one of its elements, as in `particles.loads[0].force`"));
}

TEST(SceneErrors, DuplicateKey) {
  EXPECT_EQ(about("plane: plane_stress\nplane: plane_strain\n"),
            "x.yaml:4:1: `plane` is given twice, first in line 3; keep one");
}

TEST(SceneErrors, WhatIsNotPlainYaml) {
  EXPECT_THAT(about("plane: [1\n"), StartsWith("x.yaml:4:1: is not YAML: "));
  EXPECT_THAT(about("a: b: c\n"), StartsWith("x.yaml:3:5: is not YAML: "));
  EXPECT_THAT(about("\tplane: 1\n"), HasSubstr("is not YAML: "));
  EXPECT_THAT(about("name: !include y.yaml\n"), StartsWith("x.yaml:3:7: tags (`!include`) are not read"));
  EXPECT_EQ(about("? [a, b]\n: 3\n"), "x.yaml:3:3: a key is not a name; write `name: value`");
  EXPECT_EQ(about("~: 3\n"), "x.yaml:3:1: a key is not a name; write `name: value`");
  EXPECT_THAT(about("---\nname: x\n"), HasSubstr("a second document begins here"));
  EXPECT_THAT(about("name: " + std::string(100, '[') + std::string(100, ']') + "\n"),
              StartsWith("x.yaml:3:38: is nested more than 32"));
}

// The first key or value of the file that cannot be read, or lies beyond its limits, is reported.
TEST(SceneErrors, TheFirstErrorInTheFileIsReported) {
  EXPECT_THAT(about("plane: wrong\nfluid: 3\n"), StartsWith("x.yaml:3:1: plane"));
  EXPECT_THAT(about("fluid: 3\nplane: wrong\n"), StartsWith("x.yaml:3:1: fluid"));
  EXPECT_THAT(complaint_about("time: {duratoin: 1 s}\n"), HasSubstr("did you mean `duration`?"));
}

TEST(SceneErrors, FilesThatCannotBeRead) {
  const ScratchFolder folder;
  EXPECT_EQ(complaint(folder, "no.yaml"), "no.yaml: there is no such file; check the path");
  EXPECT_EQ(complaint(folder, ""), ": this is not a file; name a scene file");
  folder.write("large.yaml", kHead + "#" + std::string(kLargestSceneBytes, '.'));
  EXPECT_EQ(complaint(folder, "large.yaml"),
            "large.yaml: the file is larger than 4 MiB; thin out its tables");
}

TEST(SceneErrors, ExtendedFilesThatCannotBeRead) {
  EXPECT_THAT(about("extends: no.yaml\n"), StartsWith("x.yaml:3:1: extends: `"));
  EXPECT_THAT(about("extends: no.yaml\n"), HasSubstr("there is no such file"));
  EXPECT_THAT(about("extends: .\n"), HasSubstr("this is not a file"));
  EXPECT_EQ(about("base: [a.yaml]\n"),
            "x.yaml:3:1: extends: expected the path of a scene file, such as `other.yaml`");
  EXPECT_EQ(about("extends:\n"),
            "x.yaml:3:1: extends: expected the path of a scene file, such as `other.yaml`");
  EXPECT_THAT(about("extends: x.yaml\n"), HasSubstr("extends this file; no scene extends itself"));
  EXPECT_EQ(about("extends: y.yaml\nbase: y.yaml\n"),
            "x.yaml:4:1: base: is given beside `extends`, its new name; keep that");
  const ScratchFolder folder;
  folder.write("a.yaml", "extends: b.yaml\n");
  folder.write("b.yaml", "extends: ./a.yaml\n");
  EXPECT_THAT(complaint(folder, "a.yaml"), StartsWith("b.yaml:1:1: extends: "));
}

// A value from an extended file is blamed on its line there, a field missing from both on the file itself.
TEST(SceneErrors, ErrorsInAnExtendedFileNameThatFile) {
  const ScratchFolder folder;
  folder.write("base.yaml", "\n" + kHead + "plane: wrong\n");
  folder.write("x.yaml", "extends: base.yaml\n");
  EXPECT_THAT(complaint(folder, "x.yaml"), StartsWith("base.yaml:4:1: plane: is `wrong`"));
  folder.write("x.yaml", "extends: base.yaml\nplane: plane_stress\nparticles: {packing: {}}\n");
  EXPECT_THAT(complaint(folder, "x.yaml"), StartsWith("x.yaml:3:13: particles.packing.x_min: is missing"));
}

TEST(SceneErrors, SetsAreNamedAsTheyWereWritten) {
  EXPECT_EQ(about("", {"time.duration=-1 s"}),
            "--set time.duration=-1 s: time.duration: is -1 s, expected a time above 0 s");
  EXPECT_THAT(about("", {"time.durtion=1 s"}),
              StartsWith("--set time.durtion=1 s: time.durtion: unknown; did you mean `duration`?"));
  EXPECT_THAT(about("", {"tim.duration=1 s"}),
              StartsWith("--set tim.duration=1 s: tim: unknown; did you mean `time`?"));
  EXPECT_THAT(about("", {"time=[1"}), StartsWith("--set time=[1:"));
  EXPECT_THAT(about("", {"time="}), StartsWith("--set time=: time: is empty, expected a mapping"));
  EXPECT_EQ(
      about("output: {field_times: [1 s]}\n", {"output.field_times[1]=2 s"}),
      "--set output.field_times[1]=2 s: output.field_times[1]: does not exist; output.field_times has 1 "
      "elements, counted from 0");
  EXPECT_THAT(about("", {"time.duration.x=2 s"}),
              HasSubstr("time.duration: is a mapping, expected a time above 0 s"));
  EXPECT_THAT(
      about("", {"particles.bonds={tensile_strength: 1 kg}"}),
      HasSubstr("particles.bonds.tensile_strength: `1 kg` is a mass; a force such as `5 MN` is expected"));
  EXPECT_THAT(about("", {"extends=y.yaml"}), HasSubstr("extends: can only be given in the scene file"));
  for (const std::string path :
       {"a..b", ".a", "a.", "a[", "a[]", "a[x]", "a[1", "a[1]b", "[1]", "a[-1]", "0.a", "a.0.1", "a[0].1"})
    EXPECT_THAT(about("", {path + "=1"}), HasSubstr("is not a path such as `particles.loads[0].force.y`"))
        << path;
  std::string deep = "a";
  for (int i = 0; i < 50000; ++i) deep += ".a";
  EXPECT_THAT(about("", {deep + "=1"}), HasSubstr("is not a path"));
  for (const std::string text : {"time.duration", "=1", ""})
    EXPECT_THAT(about("", {text}), StartsWith("--set " + text + ": is not path=value")) << text;
}

// Whatever the user wrote, the message is one short line.
TEST(SceneErrors, MessagesAreOneLine) {
  const std::string text = about("\"two\\nlines" + std::string(5000, 'x') + "\": 3\n");
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_LT(text.size(), 300u);
}

}  // namespace
}  // namespace adit::protocol::reader_errors_test
