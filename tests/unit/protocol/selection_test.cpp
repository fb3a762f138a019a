#include "protocol/selection.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

const std::vector<double> kPoints{0, 0, 1, 0, 2, 0, 2, 5};  // (0,0) (1,0) (2,0) (2,5)

TEST(Selection, PointsOnTheEdgeOfTheBoxAreInside) {
  scene::Box box;
  box.set_x_min(1);
  box.set_x_max(2);
  box.set_y_min(0);
  box.set_y_max(0);
  EXPECT_THAT(select(box, kPoints, 0, "where", "particles"), ::testing::ElementsAre(1, 2));
}

TEST(Selection, ASideThatIsLeftOutIsUnbounded) {
  scene::Box box;
  EXPECT_THAT(select(box, kPoints, 0, "where", "particles"), ::testing::ElementsAre(0, 1, 2, 3));
  box.set_x_min(1.5);
  EXPECT_THAT(select(box, kPoints, 0, "where", "particles"), ::testing::ElementsAre(2, 3));
  box.set_y_max(1);
  EXPECT_THAT(select(box, kPoints, 0, "where", "particles"), ::testing::ElementsAre(2));
}

TEST(Selection, TheToleranceWidensEverySide) {
  scene::Box box;
  box.set_x_min(0);
  box.set_x_max(1);
  box.set_y_min(0);
  box.set_y_max(1);
  for (const auto& [x, y] :
       {std::pair(-0.1, 0.5), std::pair(1.1, 0.5), std::pair(0.5, -0.1), std::pair(0.5, 1.1)}) {
    EXPECT_FALSE(inside(box, x, y, 0.05));
    EXPECT_TRUE(inside(box, x, y, 0.15));
  }
}

TEST(Selection, SelectingNothingNamesThePathAndThePoints) {
  scene::Box box;
  box.set_x_min(3);
  try {
    select(box, kPoints, 0, "particles.loads[0].where", "particles");
    FAIL() << "an empty selection was accepted";
  } catch (const UserError& error) {
    EXPECT_EQ(error.path(), "particles.loads[0].where");
    EXPECT_STREQ(error.what(), "selects no particles; widen the box so that it holds at least one");
  }
}

}  // namespace
}  // namespace adit::protocol
