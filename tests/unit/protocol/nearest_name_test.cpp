#include "protocol/nearest_name.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace adit::protocol::nearest_name_test {
namespace {

TEST(NearestName, DistanceCountsInsertionsDeletionsReplacementsAndExchanges) {
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("radus", "radius"), 1);
  EXPECT_EQ(edit_distance("raddius", "radius"), 1);
  EXPECT_EQ(edit_distance("radiis", "radius"), 1);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1);
  EXPECT_EQ(edit_distance("RADIUS", "radius"), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestName, TheNearestOfTheKnownIsFoundAndGarbageIsNot) {
  const std::vector<std::string> known{"x_min", "x_max", "y_min", "y_max", "radius"};
  EXPECT_EQ(nearest_name("radus", known), "radius");
  EXPECT_EQ(nearest_name("x_mx", known), "x_max");
  EXPECT_EQ(nearest_name("density", known), "");
  EXPECT_EQ(nearest_name(std::string(1 << 20, 'a'), known), "");
  EXPECT_EQ(did_you_mean("radus", known), "; did you mean `radius`?");
  EXPECT_EQ(did_you_mean("density", known), "");
}

}  // namespace
}  // namespace adit::protocol::nearest_name_test
