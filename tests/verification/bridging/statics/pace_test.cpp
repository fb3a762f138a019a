// Requirement: masses of statics bring zones of different size, a stiff lining and discs of different size to
// rest in a fraction of the steps, and the state of rest is the same.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::pace_test {
namespace {

struct Settled {
  std::uint64_t steps;
  std::vector<double> displacements;  // of the first piece of every model
};

Settled settle(const std::string& text, const std::string& how) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text + how, &scene)) << text << how;
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  Settled settled{relax(model, stepper).steps, {}};
  for (const wire::Snapshot& snapshot : stepper.snapshots())
    for (const wire::Field& field : snapshot.pieces(0).point_fields())
      if (field.name() == "displacement_m")
        settled.displacements.insert(settled.displacements.end(), field.values().begin(),
                                     field.values().end());
  return settled;
}

// Largest difference of a displacement, over the largest displacement.
double difference(const Settled& a, const Settled& b) {
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < a.displacements.size(); ++i) {
    largest = std::max(largest, std::abs(a.displacements[i]));
    apart = std::max(apart, std::abs(a.displacements[i] - b.displacements[i]));
  }
  return apart / largest;
}

const char* const kTrueMasses =
    "statics { unbalanced_ratio: 1e-6 keep_displacements: true scale_masses: false } ";
const char* const kScaledMasses = "statics { unbalanced_ratio: 1e-6 keep_displacements: true } ";

// A tunnel whose pressure is let go, in zones that grow outwards to the outline, which is held.
std::string tunnel(const std::string& lining) {
  return "material { young_modulus: 1e9 poisson_ratio: 0.25 density: 2000 } time { duration: 1e-3 } "
         "initial_stress { xx: -5e6 yy: -10e6 } "
         "continuum { "
         "blocks { name: 'core' rectangle { x_min: -1 x_max: 1 y_min: -1 y_max: 1 } along { zones: 8 } "
         "across { zones: 8 } } "
         "blocks { name: 'core' ring { centre { x: 0 y: 0 } inner_side: 2 outer_radius: 2 } "
         "along { zones: 32 } across { zones: 3 } } "
         "blocks { ring { centre { x: 0 y: 0 } inner_radius: 2 outer_side: 60 } along { zones: 32 } "
         "across { zones: 20 ratio: 1.15 } } "
         "excavations { where { group: 'core' } stage: 1 } " +
         lining +
         "motions { where { x_min: 30 } velocity { x: 0 y: 0 } } "
         "motions { where { x_max: -30 } velocity { x: 0 y: 0 } } "
         "motions { where { y_min: 30 } velocity { x: 0 y: 0 } } "
         "motions { where { y_max: -30 } velocity { x: 0 y: 0 } } } ";
}

TEST(MassesOfStatics, BringGradedGroundToTheSameRest) {
  const Settled with = settle(tunnel(""), kScaledMasses), without = settle(tunnel(""), kTrueMasses);
  EXPECT_LT(difference(with, without), 2e-4);
  EXPECT_LT(static_cast<double>(with.steps), 0.5 * static_cast<double>(without.steps));
}

TEST(MassesOfStatics, BringALinedTunnelToTheSameRest) {
  const std::string scene = tunnel(
      "linings { name: 'l' along { circle { centre { x: 0 y: 0 } radius: 2 } } thickness: 0.2 "
      "young_modulus: 3e10 poisson_ratio: 0.2 stage: 1 } ");
  const Settled with = settle(scene, kScaledMasses), without = settle(scene, kTrueMasses);
  EXPECT_LT(difference(with, without), 1e-3);
  EXPECT_LT(static_cast<double>(with.steps), 0.5 * static_cast<double>(without.steps));
}

// Soft and stiff bonded discs in a coupled ring of zones. The number of steps hangs on the last digits:
// moduli that differ by 1e-5 need 0.35 to 0.44 of the steps.
TEST(MassesOfStatics, BringACoupledPackingToTheSameRest) {
  const std::string scene =
      "material { young_modulus: 1e8 poisson_ratio: 0.2 density: 2000 } time { duration: 1e-3 } "
      "continuum { block { x_min: 0 x_max: 16 y_min: 0 y_max: 10 zones_x: 32 zones_y: 20 } "
      "body_loads { acceleration { y: -10 } } "
      "motions { where { x_max: 0 } velocity { x: 0 } } "
      "motions { where { x_min: 16 } velocity { x: 0 } } "
      "motions { where { y_max: 0 } velocity { x: 0 y: 0 } } } "
      "particles { engine: GENERAL bonds {} "
      "packing { x_min: 4 x_max: 12 y_min: 1 y_max: 9 radius: 0.2 } "
      "groups { name: 'stiff' where { x_min: 7 x_max: 9 y_min: 4 y_max: 6 } "
      "material { young_modulus: 3e10 poisson_ratio: 0.2 density: 2500 } } "
      "body_loads { acceleration { y: -10 } } } "
      "interface { overlap { around { box { x_min: 6 x_max: 10 y_min: 3 y_max: 7 } } width: 1.5 } } ";
  const Settled with = settle(scene, kScaledMasses), without = settle(scene, kTrueMasses);
  EXPECT_LT(difference(with, without), 1e-3);
  EXPECT_LT(static_cast<double>(with.steps), 0.55 * static_cast<double>(without.steps));
}

}  // namespace
}  // namespace adit::pace_test
