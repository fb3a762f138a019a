// Requirement: what the energies of a participant gain is the work that loads and multipliers do on it, from
// the first half step on, in each participant by itself.
#include "coupler/stepping/ledger.hpp"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::ledger_test {
namespace {

// The zones fall from the start, and the particles hold them back.
scene::Scene bar() {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    plane: PLANE_STRESS
    material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 }
    time { duration: 0.04 }
    continuum {
      block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 }
      body_loads { acceleration { x: 2 y: -10 } }
    }
    particles {
      packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.05 }
      motions { where { x_min: 3.92 } velocity { x: 0 y: 0 } spin: 0 }
    }
    interface { overlap { particles_begin { x: 1.3 y: 0 } continuum_ends { x: 2.7 y: 0 } } }
  )",
                                                            &scene));
  return scene;
}

double unexplained(const coupler::ParticipantEnergies& e) {
  return e.kinetic + e.strain + e.released + e.dissipated - e.external_work - e.multiplier_work;
}

TEST(Ledger, MultipliersWorkClosesTheBalanceOfEachParticipant) {
  coupler::Model model = test::local_model(bar());
  coupler::Stepper stepper(model);
  EXPECT_EQ(stepper.ledger().kept(), 1) << "nothing has done work yet";
  std::vector<double> start, largest(2, 0.0);
  for (std::uint64_t n = 0; n <= 20; ++n) {
    stepper.step(n, {.energies = true});
    const auto& energies = stepper.ledger().energies();
    ASSERT_EQ(energies.size(), 2u);
    for (std::size_t s = 0; s < 2; ++s) {
      if (n == 0) start.push_back(unexplained(energies[s]));
      largest[s] = std::max(largest[s], std::abs(energies[s].multiplier_work));
      EXPECT_NEAR(unexplained(energies[s]), start[s], 1e-9 * largest[s])
          << "step " << n << ", participant " << s;
    }
  }
  for (const double work : largest) EXPECT_GT(work, 0);
}

}  // namespace
}  // namespace adit::ledger_test
