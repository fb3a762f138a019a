// Requirements on files that a scene names: their contents are sent with it.
#include "protocol/scene/attached_files.hpp"

#include <gmock/gmock.h>

#include "protocol/scene/hash.hpp"
#include "protocol/scene/writer.hpp"
#include "protocol/wire/bounds.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/scene/scene_files.hpp"

namespace adit::protocol::attached_files_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ScratchFolder;

SceneFile read_attached(const ScratchFolder& folder, const std::string& name,
                        const std::vector<std::string>& sets = {}) {
  SceneFile file = read_scene(folder.path(name), parse_overrides(sets));
  attach_files(file);
  return file;
}

const std::string kMesh = "time: {duration: 1 s}\ncontinuum:\n  mesh: {path: ground.msh}\n";

// Requirement: a file is looked for beside the scene file that names it, also where that is a base of another
// one.
TEST(AttachedFiles, AreReadBesideTheFileThatNamesThem) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "base");
  folder.write("base/scene.yaml", kMesh);
  folder.write("base/ground.msh", "nodes\nand elements");
  folder.write("variant.yaml",
               "extends: base/scene.yaml\nregions: [{name: far, continuum: {mesh: {path: far.msh}}}]\n");
  folder.write("far.msh", "far");
  const SceneFile file = read_attached(folder, "variant.yaml");
  EXPECT_EQ(file.scene.continuum().mesh().content(), "nodes\nand elements");
  EXPECT_EQ(file.scene.regions(0).continuum().mesh().content(), "far");
}

// Requirement: what is computed has one name wherever its files lie, and another one where they differ.
TEST(AttachedFiles, TheirContentIsPartOfTheHash) {
  const ScratchFolder here, there;
  here.write("scene.yaml", kMesh);
  there.write("scene.yaml", kMesh);
  here.write("ground.msh", "nodes");
  there.write("ground.msh", "nodes");
  const std::string hash = scene_hash(read_attached(here, "scene.yaml").scene);
  EXPECT_EQ(scene_hash(read_attached(there, "scene.yaml").scene), hash);
  there.write("ground.msh", "other nodes");
  EXPECT_NE(scene_hash(read_attached(there, "scene.yaml").scene), hash);
}

// Requirement: a scene that is written elsewhere finds its files again.
TEST(AttachedFiles, AreFoundFromWhereTheSceneIsWritten) {
  const ScratchFolder here, there;
  here.write("scene.yaml", kMesh);
  here.write("ground.msh", "nodes");
  there.write("again.yaml", to_yaml(read_attached(here, "scene.yaml").scene));
  EXPECT_EQ(read_attached(there, "again.yaml").scene.continuum().mesh().content(), "nodes");
}

// Requirement: the content is the programs' affair: scenes neither state it nor show it.
TEST(AttachedFiles, AreNeitherWrittenNorShown) {
  const ScratchFolder folder;
  folder.write("scene.yaml", kMesh);
  folder.write("ground.msh", "secret");
  EXPECT_THAT(to_yaml(read_attached(folder, "scene.yaml").scene),
              AllOf(HasSubstr("ground.msh"), Not(HasSubstr("secret"))));
  folder.write("told.yaml", "time: {duration: 1 s}\ncontinuum: {mesh: {path: ground.msh, content: x}}");
  test::expect_refusal([&] { read_attached(folder, "told.yaml"); }, "",
                       "continuum.mesh.content: unknown; known here: path");
}

TEST(AttachedFiles, AMissingFileIsNamedWithItsPlace) {
  const ScratchFolder folder;
  folder.write("scene.yaml", kMesh);
  for (const auto& [path, reason] :
       {std::pair("ground.msh", "there is no such file"), {".", "this is not a file"}}) {
    const std::string set = std::string("continuum.mesh.path=") + folder.path(path);
    test::expect_refusal([&] { read_attached(folder, "scene.yaml", {set}); }, "continuum.mesh.path", reason);
  }
}

// Requirement: the bound is that of all files together. The second file has no content and its size alone.
TEST(AttachedFiles, AreRefusedWhereTheyAreTooLongTogether) {
  const ScratchFolder folder;
  folder.write("scene.yaml", kMesh + "regions: [{name: far, continuum: {mesh: {path: far.msh}}}]\n");
  folder.write("ground.msh", "nodes");
  folder.write("far.msh", "");
  std::filesystem::resize_file(folder.path("far.msh"), kMaxAttachedBytes - 4);
  test::expect_refusal([&] { read_attached(folder, "scene.yaml"); }, "regions[0].continuum.mesh.path",
                       "with this file those of the scene are larger than 500 MiB");
}

}  // namespace
}  // namespace adit::protocol::attached_files_test
