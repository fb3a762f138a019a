// Requirements on what is in equilibrium: it stays at rest, whatever stands side by side at its points.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::rest_test {
namespace {

// Stressed ground between free fields, or on quiet edges, stands on a foundation with dashpots. All forces
// balance, so that no dashpot may see a motion: each needs the forces of all others to know that there is
// none.
TEST(Rest, OfStressedGroundOnAFoundationBesideOtherSupports) {
  const std::string foundations =
      "foundations { x { stiffness: 1e7 dashpot: 1e6 } y { stiffness: 1e7 dashpot: 1e6 } } foundations { x { "
      "stiffness: 2e7 dashpot: 3e6 } } ";
  for (const std::string sides :
       {"free_field { left: true right: true } ",
        "quiet { where { x_max: 0 } } quiet { where { x_min: 6 } source_distance: 20 } "}) {
    wire::Setup setup = setup_of(
        foundations + sides +
            "motions { where { y_max: 0 } velocity { y: 0 } } "
            "damping { rayleigh { ratio: 0.05 low_frequency: 1 high_frequency: 10 } } "
            "histories { name: 'a' quantity: VELOCITY_X at { x: 0 y: 0.5 } } "
            "histories { name: 'b' quantity: VELOCITY_X at { x: 5.7 y: 0.5 } } ",
        kBlock, "plane: PLANE_STRAIN material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } ");
    setup.mutable_scene()->mutable_initial_stress()->set_xx(-1e6);
    FdmParticipant participant;
    wire::Model model;
    wire::Interface interface;
    set_up(participant, setup, model);
    participant.weigh({}, interface);
    const double dt = 0.5 * model.critical_dt(),
                 kick = 1e6 * dt / (2000 * 0.5);  // by the stress on a half zone
    for (std::uint64_t step = 0; step <= 50; ++step) {
      wire::Advance advance;
      advance.set_step(step);
      advance.set_dt(dt);
      advance.set_want_histories(true);
      wire::Predicted predicted;
      participant.advance(advance, predicted);
      for (const double velocity : predicted.histories())
        ASSERT_LT(std::abs(velocity), 1e-12 * kick) << sides << step;
    }
  }
}

}  // namespace
}  // namespace adit::fdm::test::rest_test
