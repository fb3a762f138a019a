// Requirements on integration and on what is accepted as a motion.
#include <gmock/gmock.h>

#include <limits>

#include "tests/unit/protocol/motion/support.hpp"

namespace adit::motion::test::motion_test {
namespace {

using testing::HasSubstr;

// Velocity and displacement begin at zero, and are exact for an acceleration that is a straight line.
TEST(Integrate, IsExactForAStraightLine) {
  const Course course = integrate(sampled(0.01, 501, [](double t) { return 3 - 2 * t; }));
  EXPECT_EQ(course.velocity.front(), 0);
  EXPECT_EQ(course.displacement.front(), 0);
  for (std::size_t i = 0; i < 501; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(course.velocity[i], 3 * t - t * t, 1e-12);
    EXPECT_NEAR(course.displacement[i], 1.5 * t * t - t * t * t / 3, 1e-12);
  }
}

// The error of the integrals of a sine falls with the square of the step.
TEST(Integrate, IsOfSecondOrderForASine) {
  const double w = 2 * kPi;
  const auto error = [&](double dt, std::size_t count) {
    const Course course = integrate(sampled(dt, count, [&](double t) { return std::sin(w * t); }));
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = dt * static_cast<double>(i);
      largest = std::max(largest, std::abs(course.displacement[i] - (t / w - std::sin(w * t) / (w * w))));
    }
    return largest;
  };
  EXPECT_NEAR(error(0.02, 101) / error(0.01, 201), 4, 0.02);
}

// A motion that cannot be computed with is refused in words.
TEST(Motion, RefusesWhatIsNoMotion) {
  EXPECT_THAT(complaint([] {
                check({0, {1}});
              }),
              HasSubstr("time step of the motion is 0; give a value above 0"));
  EXPECT_THAT(complaint([] { check({0.01, {}}); }), HasSubstr("no values"));
  EXPECT_THAT(complaint([] {
                check({0.01, {1, std::numeric_limits<double>::quiet_NaN()}});
              }),
              HasSubstr("value 2 of the motion is nan"));
}

// A motion shorter than asked is refused with both durations; one that is as long is not.
TEST(Motion, RefusesToBeShorterThanAsked) {
  const Motion motion{0.1, std::vector<double>(101)};
  EXPECT_EQ(complaint([&] { require_duration(motion, 10, "kobe.AT2"); }), "");
  EXPECT_THAT(complaint([&] { require_duration(motion, 40, "kobe.AT2"); }),
              HasSubstr("kobe.AT2 lasts 10 s, but 40 s are asked for"));
}

}  // namespace
}  // namespace adit::motion::test::motion_test
