// Requirements on the time step of ground with a stiff lining.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::stiff_lining_test {
namespace {

constexpr const char* kSoil = "material { young_modulus: 100e6 poisson_ratio: 0.3 density: 2000 } ";

// Level, between these two x.
std::string lining(int from, int to, double y, double young) {
  return fmt::format(
      "linings {{ name: 'at_{}' along {{ line {{ points {{ x: {} y: {} }} points {{ x: {} y: {} }} }} }} "
      "thickness: 0.3 young_modulus: {} poisson_ratio: 0.2 density: 2500 }} ",
      y, from, y, to, y, young);
}
std::string wall(int from, int to) {
  return lining(from, to, 0.5, 30e9);
}

const std::string kQuietSide = "quiet { where { x_max: 0 } } ";
const std::string kFoundation = "foundations { x { stiffness: 1e6 } } ";

wire::Model model_of(const std::string& conditions, bool alone) {
  FdmParticipant participant;
  wire::Setup setup = setup_of(conditions, kBlock, kSoil);
  setup.set_alone(alone);
  wire::Model model;
  set_up(participant, setup, model);
  return model;
}

// Ground alone gives the step of ground with a stiff lining, which moves by mean acceleration.
TEST(StiffLining, LeavesTheStepToTheGround) {
  const wire::Model with = model_of(wall(1, 5), true);
  EXPECT_EQ(with.critical_element(), "zone");
  EXPECT_EQ(with.critical_dt(), model_of("", true).critical_dt());
  EXPECT_GT(with.critical_dt(), 3 * with.critical_static_dt());
}

// Where forces at its points are needed before all are known, its own step counts: another model may be
// joined, or it ends on dashpots or stands on a foundation; with local damping, too.
TEST(StiffLining, CountsWhereItCannotWait) {
  const double own = model_of(wall(1, 5), false).critical_dt();
  EXPECT_EQ(model_of(wall(1, 5), false).critical_element(), "beam");
  EXPECT_EQ(model_of(wall(1, 5) + kQuietSide, true).critical_element(), "zone");
  EXPECT_EQ(model_of(wall(0, 5) + kQuietSide, true).critical_element(), "beam");
  EXPECT_NEAR(model_of(wall(0, 5) + kQuietSide, true).critical_dt(), own, 1e-9 * own);
  EXPECT_EQ(model_of(wall(0, 5) + kFoundation, true).critical_element(), "beam on its foundation");
  EXPECT_EQ(model_of(wall(1, 5) + "damping { local { alpha: 0.1 } } ", true).critical_element(), "beam");
}

// Energy is kept at the whole critical step, also where a lining ends on dashpots, and where a soft one does
// so beside a stiff one.
TEST(StiffLining, KeepsEnergyAtTheCriticalStep) {
  const std::string blow =
      "edge_loads { where { x_min: 6 } force { x: -1e5 y: 4e4 } time { sine { frequency: 200 } } } ";
  for (const std::string& conditions : {wall(1, 5), wall(1, 5) + kQuietSide, wall(0, 5) + kQuietSide,
                                        wall(1, 5) + lining(0, 5, 0.25, 50e6) + kQuietSide}) {
    wire::Setup setup = setup_of(blow + conditions, kBlock, kSoil);
    setup.set_alone(true);
    FdmParticipant participant;
    wire::Model model;
    set_up(participant, setup, model);
    wire::Interface interface;
    participant.weigh({}, interface);
    double peak = 0, drift = 0;
    for (std::uint64_t n = 0; n < 3000; ++n) {
      wire::Advance advance;
      advance.set_step(n);
      advance.set_dt(model.critical_dt());
      advance.set_want_energies(true);
      wire::Predicted predicted;
      participant.advance(advance, predicted);
      const wire::Energies& e = predicted.energies();
      peak = std::max(peak, e.kinetic() + e.strain());
      drift = std::max(drift, std::abs(e.kinetic() + e.strain() + e.dissipated() - e.external_work()));
    }
    EXPECT_LE(drift, 1e-11 * peak) << conditions;
    EXPECT_GT(peak, 0);
  }
}

}  // namespace
}  // namespace adit::fdm::test::stiff_lining_test
