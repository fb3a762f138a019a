// Requirement: any grid can be a side of an overlap. One block or several, straight or slanted zones make no
// difference to the method.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::coupled_grid_test {
namespace {

// A free bar, zones left, particles right, pushed on its zones; lightly, since bonds that turn keep the
// energy only so far as their turning is small.
struct Response {
  std::vector<double> tip;  // of the zones [m]
  double energy_error, peak;
};

Response respond(const std::string& grid) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "plane: PLANE_STRESS material { young_modulus: 1e9 poisson_ratio: 0.2 density: 2000 } time { duration: "
      "0.02 } "
      "continuum { " +
          grid +
          "  edge_loads { where { x_max: 0 } force { x: 30 y: 10 } time { sine { frequency: 100 end: 0.005 "
          "} } } "
          "  histories { name: 'tip' quantity: DISPLACEMENT_X at { x: 0 y: 0 } } } "
          "particles { packing { x_min: 0 x_max: 4 y_min: 0 y_max: 1 radius: 0.05 } } "
          "interface { overlap { particles_begin { x: 1.3 y: 0 } continuum_ends { x: 2.7 y: 0 } } }",
      &scene));
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  Response response{{}, 0, 0};
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = true, .histories = true});
    response.tip.push_back(model.participants[0].prediction().histories(0));
    response.energy_error = std::max(response.energy_error, std::abs(stepper.ledger().unexplained()));
    response.peak = std::max(response.peak, std::abs(response.tip.back()));
  }
  return response;
}

std::string quadrilateral(double lower_left, double lower_right, double upper_left, double upper_right) {
  const auto corner = [](double x, double y) {
    return "corners { x: " + std::to_string(x) + " y: " + std::to_string(y) + " } ";
  };
  return "blocks { quadrilateral { " + corner(lower_left, 0) + corner(lower_right, 0) +
         corner(upper_right, 1) + corner(upper_left, 1) + "} along { zones: 4 } across { zones: 2 } } ";
}

TEST(CoupledGrid, JoinedBlocksAreOneBlock) {
  const auto one = respond("block { x_min: 0 x_max: 4 y_min: 0 y_max: 1 zones_x: 8 zones_y: 2 }");
  const auto joined = respond(quadrilateral(0, 2, 0, 2) + quadrilateral(2, 4, 2, 4));
  ASSERT_EQ(one.tip.size(), joined.tip.size());
  for (std::size_t n = 0; n < one.tip.size(); ++n) EXPECT_NEAR(one.tip[n], joined.tip[n], 1e-9 * one.peak);
}

// Slanted zones through the overlap keep the energy as straight ones do, and move the bar nearly alike.
TEST(CoupledGrid, SlantedZonesKeepTheEnergy) {
  const auto straight = respond(quadrilateral(0, 2, 0, 2) + quadrilateral(2, 4, 2, 4));
  const auto slanted = respond(quadrilateral(0, 1.8, 0, 2.2) + quadrilateral(1.8, 4, 2.2, 4));
  const double work = 30 * straight.peak;
  EXPECT_LT(straight.energy_error, 1e-10 * work);
  EXPECT_LT(slanted.energy_error, 1e-10 * work);
  EXPECT_NEAR(slanted.tip.back(), straight.tip.back(), 0.02 * straight.peak);
}

}  // namespace
}  // namespace adit::coupled_grid_test
