// Requirement: the ground may yield inside an overlap. The joined models then keep linear momentum and the
// balance of energy, of which the zones dissipate a part.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::plastic_overlap_test {
namespace {

struct Balance {
  double work = 0, dissipated = 0;
  double rise = 0;  // the largest of a step [J]
  double error = 0;
};

// A free bar, zones left, particles right, pushed on its zones so that these yield in the overlap as well.
Balance push(const std::string& law, const std::string& solve) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: 0.02 } "
      "continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 16 zones_y: 4 } "
      "  material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 " +
          law +
          " } "
          "  edge_loads { where { x_max: 0 } force { x: 300 } time { sine { frequency: 100 end: 0.005 } } } "
          "} "
          "particles { packing { x_min: 0 x_max: 6 y_min: 0 y_max: 1 radius: 0.05 } } "
          "interface { overlap { particles_begin { x: 1.5 y: 0 } continuum_ends { x: 2.5 y: 0 } } solve: " +
          solve + " }",
      &scene));
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  Balance balance;
  double before = 0;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = true, .histories = false});
    const double unexplained = stepper.ledger().unexplained();
    balance.rise = std::max(balance.rise, unexplained - before);
    balance.error = std::max(balance.error, std::abs(unexplained));
    before = unexplained;
    const auto& energies = model.participants[0].prediction().energies();
    balance.work = std::max(balance.work, energies.external_work());
    balance.dissipated = energies.dissipated();
  }
  return balance;
}

class PlasticOverlap : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Solves, PlasticOverlap, testing::Values("CONSISTENT", "LUMPED", "SPLIT"));

TEST_P(PlasticOverlap, KeepsTheBalanceOfEnergy) {
  EXPECT_EQ(push("", GetParam()).dissipated, 0);
  for (const char* law :
       {"mohr_coulomb { cohesion: 60 }", "hysteretic { hyperbola { reference_strain: 1e-7 } }"}) {
    SCOPED_TRACE(law);
    const Balance balance = push(law, GetParam());
    EXPECT_GT(balance.dissipated, 0.05 * balance.work);
    EXPECT_LE(balance.rise, 1e-9 * balance.work);
    if (GetParam() == "CONSISTENT") {
      EXPECT_LE(balance.error, 1e-9 * balance.work);
    }
  }
}

}  // namespace
}  // namespace adit::plastic_overlap_test
