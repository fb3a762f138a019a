// Requirement: the first number of a message that is not finite is named, wherever it stands; what may be
// missing or infinite by wire.proto is left out.
#include "protocol/wire/content/finite.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace adit::protocol::finite_test {
namespace {

std::string first_in(const std::string& text) {
  wire::Frame frame;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &frame)) << text;
  return first_not_finite(frame).value_or("none");
}

TEST(Finite, NamesTheNumberAndItsPlace) {
  EXPECT_EQ(first_in("advance { dt: nan }"), "advance.dt is nan");
  EXPECT_EQ(first_in("advance { impulses: [0, 1, -inf, nan] }"), "advance.impulses[2] is -inf");
  EXPECT_EQ(first_in("predicted { cracks { x: 1 } cracks { y: inf } }"), "predicted.cracks[1].y is inf");
  EXPECT_EQ(first_in("snapshot { pieces { points: [1, nan] } }"), "snapshot.pieces[0].points[1] is nan");
}

TEST(Finite, LeavesOutWhatMayBeMissingOrInfinite) {
  EXPECT_EQ(first_in("advance { dt: 1e308 impulses: [0, -1e308] }"), "none");
  EXPECT_EQ(first_in("predicted { histories: nan relaxation { drag_x: inf drag_y: inf } }"), "none");
  EXPECT_EQ(first_in("snapshot { pieces { point_fields { values: [nan, inf] } } }"), "none");
  EXPECT_EQ(first_in("bye { figures { value: nan } }"), "none");
  EXPECT_EQ(first_in("setup { scene { time { duration: inf } } }"), "none");
  EXPECT_EQ(first_in("heartbeat {}"), "none");
}

TEST(Finite, FindsOneAmongMany) {
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const std::size_t place : {0U, 37U, 999U}) {
      std::vector<double> values(1000, 1e300);
      EXPECT_TRUE(all_finite(values));
      values[place] = wrong;
      EXPECT_FALSE(all_finite(values)) << place;
    }
}

}  // namespace
}  // namespace adit::protocol::finite_test
