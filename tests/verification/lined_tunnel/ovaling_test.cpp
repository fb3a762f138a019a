// Requirement: a lined circular tunnel under far-field shear has the thrust and moment of Wang and Penzien.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/verification/lined_tunnel/lined_ring.hpp"
#include "tests/verification/lined_tunnel/ovaling.hpp"

namespace adit::fdm::test::ovaling_test {
namespace {

constexpr double kStrain = 1e-3;

struct Ground {
  double shear_modulus, poisson;
};
constexpr Ground kSaturatedClay{5e7, 0.49}, kSand{1e8, 0.3};

oracle::Tunnel tunnel(const Ground& ground, double thickness) {
  return {ground.shear_modulus, ground.poisson, 3, wall(thickness)};
}

oracle::Forces amplitudes(const oracle::Tunnel& tunnel, std::uint32_t around, double outer, const Rim& rim) {
  const PlaneLaw law = plane_strain(2 * tunnel.shear_modulus * (1 + tunnel.poisson), tunnel.poisson);
  const auto forces = forces_at_rest(rings(tunnel.radius, outer, around), around, law, tunnel.lining, rim);
  oracle::Forces largest{0, 0};
  for (const auto& at : forces) {
    largest.thrust = std::max(largest.thrust, std::abs(at.thrust));
    largest.moment = std::max(largest.moment, std::abs(at.moment));
  }
  return largest;
}

// Pure shear of the far field at the rim, as if there were no tunnel.
std::array<double, 2> free_field(double x, double y) {
  return {kStrain * y / 2, kStrain * x / 2};
}

// Within 5 % of Wang's thrust without slip everywhere; of Penzien's moment without slip and Wang's with full
// slip in undrained clay, because they exceed the full solution elsewhere; within 2 % of the full solution
// everywhere. A thick and a thin lining, the far field imposed at 15 radii.
TEST(LinedTunnel, ThrustAndMomentAreWangsAndPenziens) {
  for (const auto& ground : {kSaturatedClay, kSand})
    for (const double thickness : {0.5, 0.25}) {
      const auto here = tunnel(ground, thickness);
      const auto found = amplitudes(here, 48, 15 * here.radius, free_field);
      EXPECT_NEAR(found.thrust / (kStrain * wang_thrust_without_slip(here)), 1, 0.05);
      if (ground.poisson > 0.48) {
        EXPECT_NEAR(found.moment / (kStrain * penzien_moment_without_slip(here)), 1, 0.05);
        EXPECT_NEAR(found.moment / (kStrain * wang_full_slip(here).moment), 1, 0.05);
      }
      const oracle::Ovaling exact(here, kStrain * ground.shear_modulus);
      EXPECT_NEAR(found.thrust / std::abs(exact.thrust()), 1, 0.02);
      EXPECT_NEAR(found.moment / std::abs(exact.moment()), 1, 0.02);
    }
}

// With the displacements of the full solution at the rim, thrust and moment converge in second order.
TEST(LinedTunnel, ForcesConvergeInSecondOrder) {
  const auto here = tunnel(kSand, 0.5);
  const oracle::Ovaling exact(here, kStrain * here.shear_modulus);
  const auto rim = [&](double x, double y) {
    // the solution's frame is turned by 45 degrees
    const double r = std::hypot(x, y), angle = std::atan2(y, x), theta = angle - std::numbers::pi / 4;
    const double u = exact.radial(r) * std::cos(2 * theta), v = exact.tangential(r) * std::sin(2 * theta);
    return std::array{u * std::cos(angle) - v * std::sin(angle), u * std::sin(angle) + v * std::cos(angle)};
  };
  std::array<oracle::Forces, 3> error{};
  for (std::size_t level = 0; level < 3; ++level) {
    const auto found = amplitudes(here, 24 << level, 5 * here.radius, rim);
    error[level] = {std::abs(found.thrust / std::abs(exact.thrust()) - 1),
                    std::abs(found.moment / std::abs(exact.moment()) - 1)};
  }
  for (std::size_t level = 1; level < 3; ++level) {
    EXPECT_GE(std::log2(error[level - 1].thrust / error[level].thrust), 1.8);
    EXPECT_GE(std::log2(error[level - 1].moment / error[level].moment), 1.8);
  }
}

// A rim that moves as the free field does is felt by the inverse square of its distance: 2 % at 4 radii.
TEST(LinedTunnel, NearRimsAreFeltBySquaresOfTheirDistance) {
  const auto here = tunnel(kSand, 0.5);
  const auto at_radii = [&](double radii) { return amplitudes(here, 64, radii * here.radius, free_field); };
  const auto near = at_radii(4), middle = at_radii(8), far = at_radii(16);
  EXPECT_NEAR(near.thrust / far.thrust, 1, 0.025);
  EXPECT_NEAR(near.moment / far.moment, 1, 0.025);
  EXPECT_NEAR((far.thrust - middle.thrust) / (middle.thrust - near.thrust), 0.25, 0.05);
  EXPECT_NEAR((far.moment - middle.moment) / (middle.moment - near.moment), 0.25, 0.05);
}

}  // namespace
}  // namespace adit::fdm::test::ovaling_test
