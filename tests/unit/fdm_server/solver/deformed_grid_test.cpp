// Requirement: a run in large strain ends, saying so, where its zones have deformed so far that the time step
// is no longer stable or a zone is turned inside out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::deformed_grid_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A soft block of one column of zones on a fixed floor; its top moves down by `speed`.
std::string ended_by(int zones, const std::string& speed, double dt_factor) {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  participant.set_up(setup_of("large_strain: true motions { where { y_max: 0 } velocity { x: 0 y: 0 } } "
                              "motions { where { y_min: 1 } velocity { x: 0 y: -" +
                                  speed + " } }",
                              "block { x_min: 0 x_max: 0.25 y_min: 0 y_max: 1 zones_x: 1 zones_y: " +
                                  std::to_string(zones) + " } ",
                              "material { young_modulus: 1e6 poisson_ratio: 0.2 density: 2000 } "),
                     model);
  participant.weigh({}, interface);
  wire::Predicted predicted;
  wire::Advance advance;
  advance.set_dt(dt_factor * model.critical_dt());
  try {
    for (std::uint64_t n = 0; n < 20000; ++n) {
      advance.set_step(n);
      participant.advance(advance, predicted);
    }
  } catch (const protocol::Unstable& unstable) {
    return unstable.what();
  }
  return "";
}

TEST(DeformedGrid, EndsTheRunWhereTheStepIsNoLongerStable) {
  EXPECT_THAT(ended_by(4, "0.01", 0.99),
              AllOf(HasSubstr("have deformed so far"), HasSubstr("reduce time.dt_factor")));
}

// Every point is told where to go.
TEST(DeformedGrid, EndsTheRunWhereAZoneIsTurnedInsideOut) {
  EXPECT_THAT(ended_by(1, "1", 0.01), HasSubstr("is turned inside out"));
}

TEST(DeformedGrid, LetsZonesTurnAndStretchALittle) {
  EXPECT_EQ(ended_by(4, "0.001", 0.7), "");
}

}  // namespace
}  // namespace adit::fdm::test::deformed_grid_test
