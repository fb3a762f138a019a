// Requirements on zones that get another material: nothing moves at that instant, and from there on they
// follow the new law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "fdm_server/zones/zone_set.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::renew_test {
namespace {

constexpr double kStep = 1e-3;
const Block kBlock{0, 2, 0, 1, 6, 4};

Material material(double young, double poisson) {
  return {kDensity, young, poisson};
}

// All laws, the first one computed by the fast kernel.
std::vector<std::pair<const char*, Material>> laws() {
  Material plastic = material(20e9, 0.3), softening = plastic, elements = material(10e9, 0.1),
           reversals = elements;
  plastic.mohr_coulomb = MohrCoulomb({1e6, 0.5, 0.1, 2e5});
  softening.mohr_coulomb = MohrCoulomb({{0, {2e6, 0.5, 0.1, 2e5}}, {1e-3, {1e6, 0.5, 0, 0}}});
  const auto curve = backbone(hyperbola(1e-4, 1), 1e-6, 1e-3, 30);
  elements.hysteretic = iwan_elements(curve);
  reversals.reversals = Polyline(curve);
  return {{"elastic", material(40e9, 0.25)},
          {"plastic", plastic},
          {"softening", softening},
          {"elements", elements},
          {"reversals", reversals}};
}

// Zones of a grid with their points, which move in steps.
class Moving {
 public:
  Moving(ZoneKind kind, Grid grid, const Material& first, const Material& second)
      : kind_(kind),
        grid_(std::move(grid)),
        ground_{{first, second}, std::vector<std::uint32_t>(grid_.zones.size(), 0)},
        zones_(kind, grid_, ground_, ones(grid_)),
        ux_(grid_.x.size()),
        uy_(ux_),
        fx_(ux_),
        fy_(ux_) {
    zones_.follow(ux_.data(), uy_.data());
  }
  ZoneSet& zones() { return zones_; }
  std::span<const double> fx() const { return fx_; }
  std::span<const double> fy() const { return fy_; }

  // Each point by a displacement of its own.
  void move(double size, double seed) {
    std::vector<double> vx(ux_.size()), vy(ux_.size());
    for (std::size_t i = 0; i < ux_.size(); ++i) {
      vx[i] = size / kStep * std::sin(seed + 7.3 * static_cast<double>(i));
      vy[i] = size / kStep * std::sin(seed + 3.1 * static_cast<double>(i) + 1);
      ux_[i] += kStep * vx[i];
      uy_[i] += kStep * vy[i];
    }
    std::ranges::fill(fx_, 0.0);
    std::ranges::fill(fy_, 0.0);
    zones_.add_forces(zones_.runs(), kStep, {vx.data(), vy.data(), fx_.data(), fy_.data()});
  }
  std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> numbers(zones_.count());
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
  }
  void renew(const std::vector<std::uint32_t>& numbers) {
    for (const auto zone : numbers) ground_.of_zone[zone] = 1;
    zones_.renew(kind_, grid_, ground_, numbers, ux_.data(), uy_.data());
  }

 private:
  ZoneKind kind_;
  Grid grid_;
  Ground ground_;
  ZoneSet zones_;
  std::vector<double> ux_, uy_, fx_, fy_;
};

double largest(std::span<const double> values) {
  double found = 0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

class RenewedZonesOfEachKind : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, RenewedZonesOfEachKind, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// Requirement: a zone of any shape under any law that gets any other one pulls on its corners as before,
// bending included, and has the same stress, also across the plane where its law knows one.
TEST_P(RenewedZonesOfEachKind, PullOnTheirPointsAsBefore) {
  for (const auto& [before, first] : laws())
    for (const auto& [after, second] : laws()) {
      Moving ground(GetParam(), distorted_grid(kBlock), first, second);
      ZoneSet& zones = ground.zones();
      for (const auto zone : ground.all()) zones.set_stress(zone, {-2e6, -3e6, 4e5});
      ground.move(2e-5, 1);
      std::vector<ZoneForces> forces;
      std::vector<Stress> stresses;
      std::vector<double> across;
      for (const auto zone : ground.all()) {
        forces.push_back(zones.forces(zone));
        stresses.push_back(zones.stress(zone));
        across.push_back(zones.field(zone, ZoneField::kStressZz));
      }
      ground.renew(ground.all());
      for (const auto zone : ground.all()) {
        const ZoneForces now = zones.forces(zone);
        for (std::size_t c = 0; c < 4; ++c) {
          EXPECT_NEAR(now.x[c], forces[zone].x[c], 1e-7) << before << " to " << after;  // of 1e6 N
          EXPECT_NEAR(now.y[c], forces[zone].y[c], 1e-7) << before << " to " << after;
        }
        EXPECT_NEAR(zones.stress(zone).xx, stresses[zone].xx, 1e-7);
        EXPECT_NEAR(zones.stress(zone).yy, stresses[zone].yy, 1e-7);
        EXPECT_NEAR(zones.stress(zone).xy, stresses[zone].xy, 1e-7);
        if (!second.linear()) {
          EXPECT_NEAR(zones.field(zone, ZoneField::kStressZz), across[zone], 1e-7);
        }
      }
    }
}

// Requirement: what comes afterwards finds the new stiffness: the forces change as those of zones that always
// had it, by the same motion.
TEST_P(RenewedZonesOfEachKind, FollowTheNewLawFromThereOn) {
  const Material soft = material(10e9, 0.3), stiff = material(40e9, 0.1);
  Moving renewed(GetParam(), distorted_grid(kBlock), soft, stiff),
      always(GetParam(), distorted_grid(kBlock), stiff, soft);
  renewed.move(1e-4, 1);
  renewed.renew(renewed.all());
  renewed.move(0, 0);
  const std::vector<double> fx(renewed.fx().begin(), renewed.fx().end()),
      fy(renewed.fy().begin(), renewed.fy().end());
  renewed.move(1e-4, 2);
  always.move(1e-4, 2);
  for (std::size_t i = 0; i < fx.size(); ++i) {
    EXPECT_NEAR(renewed.fx()[i] - fx[i], always.fx()[i], 1e-12 * largest(always.fx()));
    EXPECT_NEAR(renewed.fy()[i] - fy[i], always.fy()[i], 1e-12 * largest(always.fy()));
  }
}

// Requirement: zones that were taken away come back free of stress and energy, wherever their points are, and
// their forces count from there.
TEST_P(RenewedZonesOfEachKind, ComeIntoBeingFreeOfStress) {
  for (const auto& [name, second] : laws()) {
    Moving filled(GetParam(), distorted_grid(kBlock), material(10e9, 0.3), second),
        always(GetParam(), distorted_grid(kBlock), second, second);
    protocol::Team team(1);
    filled.move(1e-4, 1);
    filled.zones().remove(std::vector<bool>(filled.zones().count(), true));
    filled.move(1e-4, 3);
    EXPECT_EQ(largest(filled.fx()), 0);
    filled.renew(filled.all());
    for (const auto zone : filled.all()) {
      EXPECT_NEAR(largest(filled.zones().forces(zone).x), 0, 1e-7) << name;
      EXPECT_NEAR(filled.zones().stress(zone).yy, 0, 1e-6) << name;
    }
    EXPECT_NEAR(filled.zones().strain_energy(team), 0, 1e-12) << name;
    filled.move(1e-6, 2);
    always.move(1e-6, 2);
    for (std::size_t i = 0; i < filled.fx().size(); ++i)
      EXPECT_NEAR(filled.fx()[i], always.fx()[i], 1e-8 * largest(always.fx())) << name;
  }
}

// Requirement: zones count once, whoever asks: those that stay, those that change, and those taken away
// again.
TEST_P(RenewedZonesOfEachKind, CountOnce) {
  const Material soft = material(10e9, 0.3), stiff = laws()[1].second;
  Moving ground(GetParam(), make_grid(kBlock), soft, stiff);
  ZoneSet& zones = ground.zones();
  protocol::Team team(2);
  for (const auto zone : ground.all()) zones.set_stress(zone, {-1e5, -1e5, 0});
  const std::vector<double> sizes(zones.count(), 1.0);
  const double whole = zones.internal_force(team, sizes), energy = zones.strain_energy(team);
  const std::vector<std::uint32_t> some{3, 4, 9, 23};
  ground.renew(some);
  std::vector<int> seen(zones.count(), 0);
  protocol::Team alone(1);
  zones.see_stresses(alone, [&](std::span<const std::uint32_t> numbers, const PlaneStresses&) {
    for (const auto number : numbers) ++seen[number];
  });
  EXPECT_EQ(seen, std::vector<int>(zones.count(), 1));
  EXPECT_NEAR(zones.internal_force(team, sizes) / whole, 1, 1e-12);
  EXPECT_NEAR(zones.strain_energy(team) / energy, (20 + 4 * soft.young / stiff.young) / 24, 1e-12);
  std::vector<bool> gone(zones.count(), false);
  gone[3] = gone[5] = true;
  zones.remove(gone);
  EXPECT_NEAR(zones.internal_force(team, sizes) / whole, 22.0 / 24, 1e-12);
  EXPECT_EQ(zones.stress(3).xx, 0);
}

}  // namespace
}  // namespace adit::fdm::test::renew_test
