// A run never deletes files that are not results.
#include "protocol/results/run_directory.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "protocol/errors.hpp"
#include "tests/unit/protocol/results/results_fixture.hpp"

namespace adit::results {
namespace {

TEST(RunDirectory, CaseIsTheFolderOfTheScene) {
  EXPECT_EQ(case_name("cases/cantilever/coupled.yaml"), "cantilever");
  EXPECT_EQ(case_name("cases/cantilever/variants/elastic.yaml"), "cantilever");
}

TEST(RunDirectory, TakesAnOlderRunOut) {
  const ScratchFolder scratch;
  const auto directory = scratch / "run";
  prepare_run_directory(directory, "cases/x.yaml");
  std::ofstream(directory / "summary.json") << "{}";
  std::filesystem::create_directory(directory / "fields");
  prepare_run_directory(directory, "cases/x.yaml");
  EXPECT_TRUE(std::filesystem::exists(directory / "summary.json"));
  clear_results(directory);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
}

TEST(RunDirectory, RefusesAFolderWithAnythingElseAndTouchesNothing) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "thesis.tex") << "x";
  std::ofstream(scratch / "summary.json") << "{}";
  EXPECT_THROW(prepare_run_directory(scratch / "", "cases/x.yaml"), protocol::UserError);
  EXPECT_TRUE(std::filesystem::exists(scratch / "thesis.tex"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "summary.json"));
}

// Requirement: the scene's own folder is never taken, so that `scene.yaml` is safe there.
TEST(RunDirectory, RefusesTheFolderOfTheScene) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << "material: {}";
  EXPECT_THROW(prepare_run_directory(scratch / "", scratch / "scene.yaml"), protocol::UserError);
  EXPECT_EQ(content_of(scratch / "scene.yaml"), "material: {}");
}

}  // namespace
}  // namespace adit::results
