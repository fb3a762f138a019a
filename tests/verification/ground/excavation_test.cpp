// Requirement: a circular tunnel excavated in stressed elastic ground deforms and redistributes the stress as
// Kirsch found in 1898; excavated in stages it ends at the same state.
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupler/stepping/statics.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::excavation_test {
namespace {

constexpr double kYoung = 1e9, kPoisson = 0.25, kShear = kYoung / (2 * (1 + kPoisson));
constexpr double kVertical = 10e6, kRatio = 0.5;  // pressure before, horizontal over vertical
constexpr double kRadius = 2, kSide = 120;

// A core in the tunnel's place, a graded ring around it; the outline, 30 radii away, is held.
std::string tunnel(const std::string& excavations, int around = 64, int outwards = 40) {
  const auto whole = [](int n) { return std::to_string(n); };
  return "material { young_modulus: 1e9 poisson_ratio: 0.25 density: 2000 } time { duration: 1e-3 } "
         "initial_stress { xx: -5e6 yy: -10e6 } statics { unbalanced_ratio: 1e-6 keep_displacements: true } "
         "continuum { "
         "blocks { name: 'core' rectangle { x_min: -1 x_max: 1 y_min: -1 y_max: 1 } along { zones: " +
         whole(around / 4) + " } across { zones: " + whole(around / 4) +
         " } } "
         "blocks { name: 'skin' ring { centre { x: 0 y: 0 } inner_side: 2 outer_radius: 2 } along { zones: " +
         whole(around) + " } across { zones: 4 } } " +
         "blocks { name: 'ground' ring { centre { x: 0 y: 0 } inner_radius: 2 outer_side: 120 } along { "
         "zones: " +
         whole(around) + " } across { zones: " + whole(outwards) + " ratio: 1.09 } } " + excavations +
         " motions { where { x_min: 60 } velocity { x: 0 y: 0 } } motions { where { x_max: -60 } velocity { "
         "x: 0 y: 0 } } "
         "motions { where { y_min: 60 } velocity { x: 0 y: 0 } } motions { where { y_max: -60 } velocity { "
         "x: 0 y: 0 } } "
         "}";
}

wire::Snapshot settled(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  relax(model, stepper);
  stepper.step(0, {.energies = true, .histories = true});
  return stepper.snapshots().front();
}

// Outward and counter-clockwise displacement caused by the excavation [m].
std::array<double, 2> kirsch_displacement(double r, double angle) {
  const double s = kRadius * kRadius / (r * r), unit = kVertical * kRadius * kRadius / (4 * kShear * r);
  return {-unit * ((1 + kRatio) - (1 - kRatio) * (4 * (1 - kPoisson) - s) * std::cos(2 * angle)),
          -unit * (1 - kRatio) * (2 * (1 - 2 * kPoisson) + s) * std::sin(2 * angle)};
}

// Stress around the circumference [Pa].
double kirsch_hoop(double r, double angle) {
  const double s = kRadius * kRadius / (r * r);
  return -kVertical / 2 * ((1 + kRatio) * (1 + s) + (1 - kRatio) * (1 + 3 * s * s) * std::cos(2 * angle));
}

const wire::Field& field(const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                         const std::string& name) {
  for (const auto& candidate : fields)
    if (candidate.name() == name) return candidate;
  throw std::out_of_range(name);
}

// Largest difference from Kirsch's displacement of the ground to three radii, over the largest displacement.
double displacement_error(const wire::Snapshot& snapshot) {
  const auto& piece = snapshot.pieces(0);
  const auto& u = field(piece.point_fields(), "displacement_m");
  double worst = 0;
  for (int i = 0; 2 * i < piece.points_size(); ++i) {
    const double x = piece.points(2 * i), y = piece.points(2 * i + 1), r = std::hypot(x, y);
    if (r < 0.999 * kRadius || r > 3 * kRadius) continue;
    const auto [out, along] = kirsch_displacement(r, std::atan2(y, x));
    const double ux = (out * x - along * y) / r, uy = (out * y + along * x) / r;
    worst = std::max(worst, std::hypot(u.values(3 * i) - ux, u.values(3 * i + 1) - uy));
  }
  return worst / (kVertical * kRadius * (1 - kPoisson) / kShear * (1 - kRatio) +
                  kVertical * kRadius * kRatio / (2 * kShear));
}

// Largest relative difference of the hoop stress in the zones around the hole.
double hoop_error(const wire::Snapshot& snapshot) {
  const auto& piece = snapshot.pieces(0);
  const auto& stress = field(piece.cell_fields(), "stress_Pa");
  double worst = 0;
  for (int z = 0; 4 * z < piece.connectivity_size(); ++z) {
    double x = 0, y = 0, nearest = HUGE_VAL;
    for (int c = 0; c < 4; ++c) {
      const auto point = static_cast<int>(piece.connectivity(4 * z + c));
      x += piece.points(2 * point) / 4;
      y += piece.points(2 * point + 1) / 4;
      nearest = std::min(nearest, std::hypot(piece.points(2 * point), piece.points(2 * point + 1)));
    }
    const double r = std::hypot(x, y);
    if (nearest > 1.001 * kRadius || r < kRadius) continue;
    const double xx = stress.values(3 * z), yy = stress.values(3 * z + 1), xy = stress.values(3 * z + 2);
    const double hoop = (xx * y * y + yy * x * x - 2 * xy * x * y) / (r * r);
    worst = std::max(worst, std::abs(hoop / kirsch_hoop(r, std::atan2(y, x)) - 1));
  }
  return worst;
}

const std::string kAtOnce = "excavations { where { circle { centre { x: 0 y: 0 } radius: 2 } } stage: 1 } ";

TEST(Excavation, DeformsTheGroundAsKirschFound) {
  const auto snapshot = settled(tunnel(kAtOnce));
  EXPECT_LT(displacement_error(snapshot), 0.02);
  EXPECT_LT(hoop_error(snapshot), 0.02);
}

// A tunnel that never was there: the ground deforms in the first relaxation, whose displacements are not
// kept, and ends at the same stress.
TEST(Excavation, OfStageZeroEndsAtTheSameStress) {
  const auto snapshot =
      settled(tunnel("excavations { where { group: 'core' } } excavations { where { group: 'skin' } } "));
  EXPECT_LT(hoop_error(snapshot), 0.02);
  for (const double u : field(snapshot.pieces(0).point_fields(), "displacement_m").values()) EXPECT_EQ(u, 0);
}

// Elastic ground does not remember the way.
TEST(Excavation, InStagesEndsAtTheSameState) {
  const auto once = settled(tunnel(kAtOnce, 32, 20));
  const auto twice =
      settled(tunnel("excavations { where { group: 'core' } stage: 1 } "
                     "excavations { where { group: 'skin' y_min: 0 } stage: 4 } "
                     "excavations { where { group: 'skin' } stage: 7 } ",
                     32, 20));
  const auto& a = field(once.pieces(0).point_fields(), "displacement_m").values();
  const auto& b = field(twice.pieces(0).point_fields(), "displacement_m").values();
  const auto& points = once.pieces(0).points();
  double largest = 0, difference = 0;
  for (int i = 0; 2 * i < points.size(); ++i) {
    if (std::hypot(points[2 * i], points[2 * i + 1]) < 0.999 * kRadius)
      continue;  // excavated: held where it was
    for (int k = 3 * i; k < 3 * i + 2; ++k) {
      largest = std::max(largest, std::abs(a[k]));
      difference = std::max(difference, std::abs(a[k] - b[k]));
    }
  }
  EXPECT_LT(difference, 1e-3 * largest);
}

}  // namespace
}  // namespace adit::excavation_test
