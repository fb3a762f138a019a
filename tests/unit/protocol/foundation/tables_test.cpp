// Tables of motions: bodies that turn, ground that differs along x; wrong tables are refused at their line.
#include <gtest/gtest.h>

#include "protocol/foundation/body_course.hpp"
#include "protocol/foundation/read.hpp"
#include "tests/support/refusals.hpp"

namespace adit::foundation::tables_test {
namespace {

scene::BodyMotion body(const std::string& content) {
  scene::BodyMotion motion;
  motion.set_path("edge.csv");
  motion.set_content(content);
  return motion;
}

scene::Foundation foundation(const std::string& content) {
  scene::Foundation foundation;
  foundation.mutable_x()->set_stiffness(1);
  foundation.mutable_ground()->set_path("along.csv");
  foundation.mutable_ground()->set_content(content);
  return foundation;
}

const std::string kBody = "time_s,vx_m_per_s,vy_m_per_s,spin_rad_per_s\n";
const std::string kAlong = "time_s,x_m,vx_m_per_s,vy_m_per_s\n";

TEST(BodyCourse, IsLinearBetweenItsTimesAndConstantBeyond) {
  const BodyCourse course(body("# an edge\n" + kBody + "1,0,2,-0.5\n\n3,1,0,0.5\n"), "body");
  EXPECT_EQ(course.at(0).y, 2);
  EXPECT_EQ(course.at(1.5).x, 0.25);
  EXPECT_EQ(course.at(2).spin, 0);
  EXPECT_EQ(course.at(9).spin, 0.5);
}

TEST(GroundCourse, IsLinearBetweenItsPlacesAndTimes) {
  const auto ground = read_ground(foundation(kAlong + "0,10,1,0\n0,20,3,0\n2,10,2,-1\n2,20,6,-3\n"), "f");
  std::vector<double> v;
  ground->velocities(Direction::kX, 1, v);
  EXPECT_EQ(v, (std::vector<double>{1.5, 4.5}));
  ground->velocities(Direction::kY, 5, v);
  EXPECT_EQ(v, (std::vector<double>{-1, -3}));
  const auto middle = ground->place(12.5);
  EXPECT_EQ(middle.share, 0.25);
  EXPECT_EQ(ground->place(0).after, 0U);
  EXPECT_EQ(ground->place(99).before, 1U);
}

TEST(GroundCourse, IsAtRestWhereNoneIsGiven) {
  scene::Foundation at_rest;
  std::vector<double> v{7};
  read_ground(at_rest, "f")->velocities(Direction::kX, 1, v);
  EXPECT_EQ(v, std::vector<double>{0});
}

TEST(Tables, RefuseWhatCannotBeRead) {
  const auto refuse_body = [](const std::string& content, const char* text) {
    test::expect_refusal([&] { BodyCourse(body(content), "motions[0].body"); }, "motions[0].body.path", text);
  };
  refuse_body("time_s,vx,vy,spin\n0,0,0,0\n", "edge.csv:1: `time_s,vx,vy,spin` is not the line of names");
  refuse_body(kBody, "holds no row");
  refuse_body(kBody + "0,0,0\n", "edge.csv:2: has 3 values, but there are 4 columns");
  refuse_body(kBody + "0,0,a,0\n", "edge.csv:2:");
  refuse_body(kBody + "1,0,0,0\n1,0,0,0\n", "the time 1 s follows 1 s");
  const auto refuse_ground = [](const std::string& content, const char* text) {
    test::expect_refusal([&] { read_ground(foundation(content), "foundations[0]"); },
                         "foundations[0].ground.path", text);
  };
  refuse_ground(kAlong + "0,2,0,0\n0,1,0,0\n", "the place 1 m follows 2 m");
  refuse_ground(kAlong + "0,1,0,0\n0,2,0,0\n1,1,0,0\n1,3,0,0\n", "the time 1 s and the place 3 m");
  refuse_ground(kAlong + "0,1,0,0\n0,2,0,0\n1,1,0,0\n", "give for each time the same places");
  test::expect_refusal([] { read_laws({}, "foundations[0]"); }, "foundations[0]", "springs in no direction");
}

}  // namespace
}  // namespace adit::foundation::tables_test
