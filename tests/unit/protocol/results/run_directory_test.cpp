// A run never deletes files that are not results, and no two write into one folder.
#include "protocol/results/run_directory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/refusals.hpp"
#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results::run_directory_test {
namespace {

TEST(RunDirectory, CaseIsTheFolderOfTheScene) {
  EXPECT_EQ(case_name("cases/cantilever/coupled.yaml"), "cantilever");
  EXPECT_EQ(case_name("cases/cantilever/variants/elastic.yaml"), "cantilever");
}

TEST(RunDirectory, TakesAnOlderRunOut) {
  const ScratchFolder scratch;
  const auto directory = scratch / "run";
  { const auto held = prepare_run_directory(directory, "cases/x.yaml"); }
  for (const char* name : {"summary.json", "summary.json.part", "scene.yaml.part"})
    std::ofstream(directory / name) << "{}";
  std::filesystem::create_directory(directory / "fields");
  const auto held = prepare_run_directory(directory, "cases/x.yaml");
  EXPECT_TRUE(std::filesystem::exists(directory / "summary.json"));
  clear_results(directory);
  const std::filesystem::directory_iterator left(directory);
  EXPECT_EQ(std::distance(left, {}), 1);
  EXPECT_TRUE(std::filesystem::exists(directory / kLockFile));
}

TEST(RunDirectory, IsHeldByOneAtATime) {
  const ScratchFolder scratch;
  const auto again = [&] { (void)prepare_run_directory(scratch / "run", "cases/x.yaml"); };
  {
    const FolderLock held = prepare_run_directory(scratch / "run", "cases/x.yaml");
    test::expect_refusal(again, "",
                         "is being written to by process " + std::to_string(::getpid()) + "; wait");
  }
  EXPECT_NO_THROW(again());
}

// Names such as `pictures` and `motion.csv` are those of a user's own things, too.
TEST(RunDirectory, RefusesAFolderInWhichNoRunHasWritten) {
  const ScratchFolder scratch;
  std::filesystem::create_directories(scratch / "mine/pictures");
  const auto prepare = [&] { (void)prepare_run_directory(scratch / "mine", "cases/x.yaml"); };
  test::expect_refusal(prepare, "", "holds `pictures`, but neither `summary.json` nor `.lock` of a run");
  for (const char* text : {"", "{}", "no json"}) {
    std::ofstream(scratch / "mine/summary.json") << text;
    test::expect_refusal(prepare, "", "but neither");
  }
  std::ofstream(scratch / "mine/summary.json") << R"({"scene_hash": "7"})";  // of a release without locks
  EXPECT_NO_THROW(prepare());
}

TEST(RunDirectory, RefusesAFolderWithAnythingElseAndTouchesNothing) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "thesis.tex") << "x";
  std::ofstream(scratch / "summary.json") << "{}";
  test::expect_refusal([&] { (void)prepare_run_directory(scratch / "", "cases/x.yaml"); }, "",
                       "give another one");
  EXPECT_TRUE(std::filesystem::exists(scratch / "thesis.tex"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "summary.json"));
}

// Requirement: the scene's own folder is never taken, so that `scene.yaml` is safe there.
TEST(RunDirectory, RefusesTheFolderOfTheScene) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << "material: {}";
  test::expect_refusal([&] { (void)prepare_run_directory(scratch / "", scratch / "scene.yaml"); }, "",
                       "holds the scene itself");
  EXPECT_EQ(content_of(scratch / "scene.yaml"), "material: {}");
}

}  // namespace
}  // namespace adit::results::run_directory_test
