// Requirement: the summary tells the widest opening of each kind of joint, its place, and how many seals
// failed.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "simplified/run_summary.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::simplified::joint_summary_test {
namespace {

// Two groups of one name and one of another, as at the portals and between them.
TEST(JointSummary, TellsTheWidestOfEachName) {
  scene::Scene scene;
  scene.mutable_time()->set_duration(1);
  auto& tunnel = *scene.mutable_simplified()->mutable_tunnel();
  for (const auto* name : {"gasket", "ring", "gasket"}) tunnel.add_joints()->set_name(name);
  tunnel.mutable_joints(0)->set_seal_limit(5e-3);
  tunnel.mutable_joints(2)->set_seal_limit(20e-3);
  Response response;
  response.joints = {{100, 0, 8e-3, 0, 0}, {200, 1, 30e-3, 0, 0}, {300, 0, 2e-3, 0, 0}, {400, 2, 9e-3, 0, 0}};
  simplified::Setup setup{};
  setup.scene = &scene.simplified();
  setup.motion.motion = {0.5, {0, 1, 0}};
  const adit::test::ScratchFolder folder;
  summarize(scene, "case", {}, setup, response, 1, folder.path());
  const auto summary = nlohmann::json::parse(std::ifstream(folder / "summary.json"));
  EXPECT_EQ(summary["gasket_count"], 3);
  EXPECT_EQ(summary["gasket_max_opening_m"], 9e-3);
  EXPECT_EQ(summary["gasket_max_opening_chainage_m"], 400);
  EXPECT_EQ(summary["gasket_seals_failed"], 1);
  EXPECT_EQ(summary["ring_count"], 1);
  EXPECT_EQ(summary["ring_max_opening_m"], 30e-3);
  EXPECT_EQ(summary["ring_seals_failed"], 0);
}

}  // namespace
}  // namespace adit::simplified::joint_summary_test
