// Requirements on what a summary says of the origin of its results.
#include "protocol/scene/origin.hpp"

#include <gmock/gmock.h>

#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/command_line.hpp"
#include "protocol/scene/hash.hpp"
#include "tests/unit/protocol/scene/scene_files.hpp"

namespace adit::protocol::origin_test {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;
using testing::ScratchFolder;

// Requirement: a shell that gets the command line again runs the same words.
TEST(Origin, QuotesTheCommandForAShell) {
  SceneCommandLine line("coupler", "");
  const char* words[] = {"coupler",           "run",   "it's here.yaml", "--set",
                         "time.duration=2 s", "--out", "a/b-c_1"};
  EXPECT_FALSE(line.parse(std::size(words), words));
  EXPECT_EQ(line.command, R"(coupler run 'it'\''s here.yaml' --set 'time.duration=2 s' --out a/b-c_1)");
}

// Requirement: every file that decides what is computed stands there with the hash of its bytes.
TEST(Origin, NamesTheSceneAndItsFiles) {
  const ScratchFolder folder;
  folder.write("scene.yaml", "time: {duration: 1 s}\ncontinuum:\n  mesh: {path: ground.msh}\n");
  folder.write("ground.msh", "a");
  SceneCommandLine line("coupler", "");
  line.scene = folder.path("scene.yaml");
  SceneFile file = read_scene(line.scene);
  attach_files(file);
  const Origin origin = origin_of(line, file, "0123abcd");
  // The FNV-1a hash of "a" as its authors publish it.
  EXPECT_THAT(origin.inputs,
              ElementsAre(Pair(line.scene, hash_of_bytes("time: {duration: 1 s}\ncontinuum:\n  "
                                                         "mesh: {path: ground.msh}\n")),
                          Pair(folder.path("ground.msh"), "af63dc4c8601ec8c")));
  EXPECT_EQ(origin.revision, "0123abcd");
}

}  // namespace
}  // namespace adit::protocol::origin_test
