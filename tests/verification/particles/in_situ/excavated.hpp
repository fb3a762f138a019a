// A tunnel in stressed ground of particles in a continuum, beside Kirsch's solution of 1898.
#pragma once

#include <complex>

#include "tests/verification/continuum/oracles/kirsch.hpp"
#include "tests/verification/particles/in_situ/in_situ.hpp"

namespace adit::test {

using fdm::oracle::CartesianStress;
using fdm::oracle::Kirsch;

inline constexpr CartesianStress kFar{-5e4, -1e5, 0};  // strains of less than a thousandth
inline constexpr double kHole = 1.5;

// In plane strain.
struct Elastic {
  double young, poisson;
  double shear() const { return young / (2 * (1 + poisson)); }
};
inline constexpr Elastic kRock{1e9, 0.2};

inline Kirsch kirsch(double radius, const Elastic& ground) {
  return Kirsch(radius, kFar, ground.shear(), ground.poisson);
}

// Particles around the tunnel in a continuum whose outline, 30 radii away, is held. The overlap begins at
// +-`inside` and is so wide; zones have the size 90 m / `zones`.
inline std::string tunnel_in(const Elastic& ground, int zones, double inside, double width,
                             const std::string& particles) {
  const std::string overlap =
      fmt::format("around {{ box {{ x_min: {0} x_max: {1} y_min: {0} y_max: {1} }} }} width: {2}", -inside,
                  inside, width);
  return fmt::format(
      "material {{ young_modulus: {} poisson_ratio: {} density: 2000 }} time {{ duration: 1e-3 }} "
      "initial_stress {{ xx: {} yy: {} }} statics {{ unbalanced_ratio: 5e-6 count_from_stage: 1 }} "
      "continuum {{ block {{ x_min: -45 x_max: 45 y_min: -45 y_max: 45 zones_x: {} zones_y: {} }} "
      "motions {{ where {{ x_max: -45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_min: 45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_max: -45 }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ y_min: 45 }} velocity {{ x: 0 y: 0 }} }} }} "
      "interface {{ overlap {{ {} }} }} particles {{ {} }} ",
      ground.young, ground.poisson, kFar.xx, kFar.yy, zones, zones, overlap, particles);
}

inline std::string tunnel_in_lattice(double disc, const std::string& more) {
  return tunnel_in(
      kRock, 90, 5, 1.5,
      fmt::format("packing {{ x_min: -7.1 x_max: 7.1 y_min: -7.1 y_max: 7.1 radius: {} }} {}", disc, more));
}

inline std::string excavation(const std::string& where, int stage, double released = 1) {
  return fmt::format(
      "excavations {{ where {{ circle {{ centre {{ x: 0 y: 0 }} radius: {} }} {} }} stage: {} released: "
      "{} }} ",
      kHole, where, stage, released);
}

// The radius of the circle as large as the cells that were taken away.
inline double radius_of_hole(std::size_t taken, double disc) {
  return std::sqrt(static_cast<double>(taken) * 2 * std::numbers::sqrt3 * disc * disc / std::numbers::pi);
}

// Difference from what a hole in ground without end does, from its wall to some distance, over that: root
// mean squares. Single discs of the stepped wall differ by two to three times as much.
inline double displacement_error(const Drawn& drawn, double radius, double distance, const Elastic& ground) {
  const Kirsch hole = kirsch(radius, ground), none = kirsch(0, ground);
  double error = 0, sum = 0;
  for (std::size_t i = 0; i < drawn.x.size(); ++i) {
    const double x = drawn.x[i], y = drawn.y[i];
    if (std::hypot(x, y) > distance) continue;
    const auto u = hole.displacement(x, y) - none.displacement(x, y);
    error += std::norm(u - std::complex(drawn.ux[i], drawn.uy[i]));
    sum += std::norm(u);
  }
  return std::sqrt(error / sum);
}

// Mean of Kirsch's stress over a circle, weighed as that of particles (observe/circles.hpp).
inline CartesianStress mean_stress(const Kirsch& exact, double x, double y, double radius) {
  CartesianStress mean{0, 0, 0};
  double total = 0;
  constexpr int kRings = 20, kAngles = 40;
  for (int k = 0; k < kRings; ++k)
    for (int n = 0; n < kAngles; ++n) {
      const double r = (k + 0.5) / kRings, angle = 2 * std::numbers::pi * n / kAngles;
      const double weight = r * (1 - r * r) * (1 - r * r);
      const auto s = exact.stress(x + radius * r * std::cos(angle), y + radius * r * std::sin(angle));
      mean.xx += weight * s.xx;
      mean.yy += weight * s.yy;
      mean.xy += weight * s.xy;
      total += weight;
    }
  return {mean.xx / total, mean.yy / total, mean.xy / total};
}

// Circles at the springline and at the crown, as near to the wall as they can lie.
inline constexpr double kCircle = 0.6, kAway = kHole + 0.7;
inline const std::string kHoop = stress_over(kAway, 0, kCircle) + stress_over(0, kAway, kCircle);

inline void expect_kirsch(Settled& settled, double disc, double displacement, double hoop) {
  const auto snapshot = settled.stepper.snapshots()[1];
  const Drawn drawn(snapshot);
  const auto all = static_cast<std::size_t>(snapshot.pieces(0).points_size()) / 2;
  const double radius = radius_of_hole(all - drawn.x.size(), disc);
  EXPECT_LT(displacement_error(drawn, radius, 3 * radius, kRock), displacement);
  const Kirsch exact = kirsch(radius, kRock);
  const auto stress = settled.histories[1];
  EXPECT_NEAR(stress[1] / mean_stress(exact, kAway, 0, kCircle).yy, 1, hoop);
  EXPECT_NEAR(stress[3] / mean_stress(exact, 0, kAway, kCircle).xx, 1, hoop);
}

}  // namespace adit::test
