// Requirement: a displacement that statics impose loads the model without inertia, to the states of closed
// forms, and holds its points there, in later stages and when time begins.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/state/archive.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::imposed_test {
namespace {

struct Loaded {
  coupler::Model model;
  coupler::Stepper stepper{model};

  explicit Loaded(const std::string& text) : model(test::local_model(parse(text))) { relax(model, stepper); }
  static scene::Scene parse(const std::string& text) {
    scene::Scene scene;
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
    return scene;
  }
  std::vector<double> histories(std::uint64_t n) {
    stepper.step(n, {.energies = true, .histories = true});
    const auto& values = model.participants[0].prediction().histories();
    return {values.begin(), values.end()};
  }
};

std::string material(const std::string& strength = "") {
  return "material { young_modulus: 1e8 poisson_ratio: 0.25 density: 2000 " + strength + " } ";
}
std::string block(int zones) {
  return "block { x_min: 0 x_max: 1 y_min: 0 y_max: 2 zones_x: " + std::to_string(zones) +
         " zones_y: " + std::to_string(2 * zones) + " } ";
}
const std::string kBase =
    "motions { where { y_max: 0 } velocity { y: 0 } } motions { where { x_max: 0 } velocity { x: 0 } } ";
const std::string kInside =
    "histories { name: 'a' quantity: STRESS_YY at { x: 0.6 y: 1.1 } } "
    "histories { name: 'b' quantity: STRESS_XX at { x: 0.6 y: 1.1 } } ";

// Plane strain with free sides: E / (1 - nu^2) times the strain.
TEST(Imposed, CompressesAPrismByHooke) {
  for (const std::string damping : {"", "damping: LOCAL", "damping: ADAPTIVE"}) {
    Loaded prism("time { duration: 0.1 } statics { unbalanced_ratio: 1e-7 keep_displacements: true " +
                 damping + " } " + material() + "continuum { " + block(5) + kBase +
                 "motions { where { y_min: 2 } displacement { y: -4e-3 } stage: 1 } " + kInside +
                 "histories { name: 'top' quantity: DISPLACEMENT_Y at { x: 0.5 y: 2 } } }");
    const double exact = -2e-3 * 1e8 / (1 - 0.25 * 0.25);
    for (const std::uint64_t n : {0, 1, 2, 3, 4, 5}) {
      const auto now = prism.histories(n);
      EXPECT_NEAR(now[0], exact, 1e-5 * std::abs(exact)) << damping << n;
      EXPECT_NEAR(now[1], 0, 1e-5 * std::abs(exact)) << damping << n;
      EXPECT_NEAR(now[2], -4e-3, 1e-12) << damping << n;
    }
    EXPECT_LE(prism.stepper.ledger().max_drift(), 1e-9);
  }
}

// Beyond its strength the prism bears 2 c tan(45 + phi/2), and nothing moves on.
TEST(Imposed, CrushesAPrismAtItsStrength) {
  const double phi = 0.5, cohesion = 5e4;
  Loaded prism("time { duration: 0.1 } statics { unbalanced_ratio: 1e-6 } " +
               material("mohr_coulomb { cohesion: 5e4 friction_angle: 0.5 dilation_angle: 0.5 }") +
               "continuum { " + block(5) + kBase +
               "motions { where { y_min: 2 } displacement { y: -2e-2 } } " + kInside + "}");
  const double strength = 2 * cohesion * std::tan(std::numbers::pi / 4 + phi / 2);
  EXPECT_NEAR(prism.histories(0)[0], -strength, 0.01 * strength);
}

// A second displacement takes what it states from where the first ended.
TEST(Imposed, ActsInItsStage) {
  const std::string text = "time { duration: 0.1 } statics { unbalanced_ratio: 1e-7 } " + material() +
                           "continuum { " + block(4) + kBase +
                           "motions { where { y_min: 2 } displacement { y: -4e-3 } } "
                           "motions { where { x_min: 1 } displacement { x: 1e-3 } stage: 2 } " +
                           kInside + "}";
  Loaded prism(text);
  // Both sides are held in the end: exx = 1e-3, eyy = -2e-3.
  const double lame = 1e8 * 0.25 / (1.25 * 0.5), shear = 1e8 / 2.5;
  const auto now = prism.histories(0);
  EXPECT_NEAR(now[0], lame * -1e-3 + 2 * shear * -2e-3, 1e-5 * shear * 4e-3);
  EXPECT_NEAR(now[1], lame * -1e-3 + 2 * shear * 1e-3, 1e-5 * shear * 4e-3);
}

// Stops and slowing take nothing of the displacement, and a state in its midst goes on to the same bits.
TEST(Imposed, GoesOnFromAState) {
  using namespace fdm;
  const Grid grid = make_grid({0, 1, 0, 2, 3, 6});
  const std::vector<double> weights(grid.zones.size(), 1.0);
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    if (grid.y[i] == 0) bottom.push_back(i);
    if (grid.y[i] == 2) top.push_back(i);
  }
  const auto none = [](double) { return 0.0; };
  const auto make = [&] {
    return Continuum(ZoneSet(ZoneKind::kAssumedStrain, grid, plane_strain(1e8, 0.25), weights),
                     lumped_masses(grid, weights, 2000), {},
                     {{bottom, Axis::kY, 0, none}, {top, Axis::kY, 0, none, -1e-3, 0}});
  };
  const auto run = [](Continuum& continuum, std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t n = from; n < to; ++n) {
      const bool stop = n % 7 == 3;
      continuum.slow(stop ? 0 : 0.9);
      continuum.step({n, 3e-4, true, stop});
    }
  };
  Continuum whole = make(), part = make(), rest = make();
  run(whole, 0, 6000);
  run(part, 0, 2345);
  state::Archive written;
  part.exchange(written);
  state::Archive read(written.take());
  rest.exchange(read);
  run(rest, 2345, 6000);
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    EXPECT_EQ(rest.uy()[i], whole.uy()[i]);
    EXPECT_EQ(rest.vy()[i], whole.vy()[i]);
  }
  for (const std::uint32_t i : top) EXPECT_NEAR(whole.uy()[i], -1e-3, 1e-15);
}

}  // namespace
}  // namespace adit::imposed_test
