#include "protocol/scene/hash.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::protocol::hash_test {
namespace {

scene::Scene small_scene() {
  scene::Scene scene;
  scene.mutable_material()->set_young_modulus(30e9);
  scene.mutable_time()->set_duration(0.05);
  return scene;
}

// The hash of nothing is the offset basis of FNV-1a: the published constant, the same on every machine.
TEST(SceneHash, IsFnv1aInSixteenHexadecimalDigits) {
  EXPECT_EQ(scene_hash(scene::Scene()), "cbf29ce484222325");
  EXPECT_EQ(scene_hash(small_scene()).size(), 16u);
}

// The test vectors of its authors (draft-eastlake-fnv, appendix C).
TEST(SceneHash, HasTheValuesThatItsAuthorsPublish) {
  EXPECT_EQ(hash_of_bytes("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hash_of_bytes("foobar"), "85944171f73967e8");
}

TEST(SceneHash, NamesDoNotChangeIt) {
  scene::Scene named = small_scene();
  named.set_name("a");
  named.set_extends("b.yaml");
  named.set_description("c");
  EXPECT_EQ(scene_hash(named), scene_hash(small_scene()));
}

TEST(SceneHash, TheLastBitOfAValueChangesIt) {
  scene::Scene changed = small_scene();
  changed.mutable_time()->set_duration(std::nextafter(0.05, 1));
  EXPECT_NE(scene_hash(changed), scene_hash(small_scene()));
}

}  // namespace
}  // namespace adit::protocol::hash_test
