// Requirements on zones of one material that differ in stiffness and strength by factors: they are to the
// rounding those of materials that have the factors in their constants, under every law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "fdm_server/materials/wave_speeds.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::scattered_zones_test {
namespace {

const Block kBlock{0, 4, 0, 2, 8, 5};

// A law of ground as so many times as stiff and as strong.
struct Law {
  const char* name;
  Material (*of)(double stiffness, double strength);
};

Material elastic(double stiffness, double strength) {
  Material ground{kDensity, stiffness * kYoung, 0.3};
  ground.fracture = MohrCoulomb({strength * 2e6, 0.4, 0, strength * 1e6}).cone(0);
  return ground;
}

Material with_strength(Material ground, double strength) {
  ground.mohr_coulomb = MohrCoulomb(
      {{0, {strength * 1e6, 0.5, 0.1, strength * 4e5}}, {1e-4, {strength * 6e5, 0.4, 0.05, strength * 1e5}}});
  return ground;
}

Material plastic(double stiffness, double strength) {
  Material ground = elastic(stiffness, strength);
  ground.mohr_coulomb = MohrCoulomb({strength * 1e6, 0.5, 0.1, strength * 4e5});
  return ground;
}

Material softening(double stiffness, double strength) {
  return with_strength(elastic(stiffness, strength), strength);
}

Material weak_planes(double stiffness, double strength) {
  Material ground = elastic(stiffness, strength);
  ground.weak_plane = WeakPlane(0.6, {strength * 5e5, 0.4, 0.05, strength * 2e5});
  return ground;
}

Material both(double stiffness, double strength) {
  return with_strength(weak_planes(stiffness, strength), strength);
}

const std::vector<BackbonePoint> kCurve = backbone(hyperbola(1e-4, 1), 1e-6, 1e-3, 30);

Material elements(double stiffness, double strength) {
  Material ground = elastic(stiffness, strength);
  ground.hysteretic = iwan_elements(kCurve);
  return ground;
}

Material reversals(double stiffness, double strength) {
  Material ground = elastic(stiffness, strength);
  ground.reversals = Polyline(kCurve);
  return ground;
}

Material limited(double stiffness, double strength) {
  return with_strength(elements(stiffness, strength), strength);
}

constexpr Law kLaws[] = {{"elastic", elastic},        {"plastic", plastic}, {"softening", softening},
                         {"weak_plane", weak_planes}, {"both", both},       {"elements", elements},
                         {"reversals", reversals},    {"limited", limited}};

// Factors of a zone, which differ from left to right: of stiffness and of strength.
std::pair<double, double> factors_at(std::uint32_t column) {
  constexpr std::pair<double, double> kFactors[] = {{1, 1}, {3, 1}, {0.7, 1.3}, {1.7, 0.6}};
  return kFactors[column % 4];
}

std::uint32_t column_of(const Grid& grid, std::size_t zone) {
  return static_cast<std::uint32_t>(std::clamp(centroid(corners(grid, zone))[0], 0.0, 3.99));
}

// One material with factors, and as many materials as there are factors.
Ground by_factors(const Law& law, const Grid& grid, bool large) {
  Ground ground{{law.of(1, 1)}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  ground.large_strain = large;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [stiffness, strength] = factors_at(column_of(grid, z));
    ground.stiffness_factor.push_back(stiffness);
    ground.strength_factor.push_back(strength);
  }
  return ground;
}

Ground by_materials(const Law& law, const Grid& grid, bool large) {
  Ground ground;
  ground.large_strain = large;
  for (std::uint32_t column = 0; column < 4; ++column) {
    const auto [stiffness, strength] = factors_at(column);
    ground.materials.push_back(law.of(stiffness, strength));
  }
  for (std::size_t z = 0; z < grid.zones.size(); ++z) ground.of_zone.push_back(column_of(grid, z));
  return ground;
}

// Held at the left, hit at the right, from a stress on, with weights.
Continuum shaken(ZoneKind kind, const Grid& grid, const Ground& ground) {
  std::vector<double> weights(grid.zones.size());
  for (std::size_t z = 0; z < weights.size(); ++z) weights[z] = 0.3 + 0.05 * static_cast<double>(z % 14);
  ZoneSet zones(kind, grid, ground, weights);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    zones.set_stress(z, {-1e5, -2e5, 3e4});
    zones.set_stress_zz(z, -1.2e5);
  }
  std::vector<std::uint32_t> left, right;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    if (grid.x[i] == 0) left.push_back(i);
    if (grid.x[i] == 4) right.push_back(i);
  }
  const std::vector<double> fx(right.size(), 8e5), fy(right.size(), -6e5);
  return Continuum(
      std::move(zones), lumped_masses(grid, weights, kDensity),
      {{right, fx, fy, [](double t) { return std::sin(2000 * t); }}},
      {{left, Axis::kX, 0.0, [](double) { return 1.0; }}, {left, Axis::kY, 0.0, [](double) { return 1.0; }}});
}

// To `rounding` of the largest of the wanted values.
template <class Value>
void expect_same(const char* what, std::size_t count, const Value& found, const Value& wanted,
                 double rounding) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(wanted(i)));
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_NEAR(found(i), wanted(i), rounding * largest) << what << ' ' << i;
}

void expect_same_zones(const ZoneSet& found, const ZoneSet& wanted, double rounding) {
  using Read = double (*)(const ZoneSet&, std::size_t);
  constexpr std::pair<const char*, Read> kReads[] = {
      {"xx", [](const ZoneSet& zones, std::size_t z) { return zones.stress(z).xx; }},
      {"yy", [](const ZoneSet& zones, std::size_t z) { return zones.stress(z).yy; }},
      {"xy", [](const ZoneSet& zones, std::size_t z) { return zones.stress(z).xy; }},
      {"zz", [](const ZoneSet& zones, std::size_t z) { return zones.field(z, ZoneField::kStressZz); }},
      {"pull", [](const ZoneSet& zones, std::size_t z) { return zones.forces(z).x[2]; }},
      {"demand", [](const ZoneSet& zones, std::size_t z) { return zones.demand(z); }},
      {"plastic",
       [](const ZoneSet& zones, std::size_t z) { return zones.field(z, ZoneField::kPlasticShearStrain); }},
      {"yields", [](const ZoneSet& zones, std::size_t z) { return zones.field(z, ZoneField::kYieldState); }}};
  for (const auto& [what, read] : kReads)
    expect_same(what, found.count(),
                std::function([&, read = read](std::size_t z) { return read(found, z); }),
                std::function([&, read = read](std::size_t z) { return read(wanted, z); }), rounding);
  protocol::Team team(1);
  const std::vector<double> sizes(found.count(), 1.0);
  EXPECT_NEAR(found.internal_force(team, sizes) / wanted.internal_force(team, sizes), 1, rounding);
}

class ScatteredZonesOfEachKind : public testing::TestWithParam<ZoneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ScatteredZonesOfEachKind, testing::ValuesIn(kKinds), [](const auto& kind) {
  return kind.param == ZoneKind::kAssumedStrain ? "AssumedStrain" : "MixedDiscretization";
});

// Requirement: shaken beyond its strength, a ground of factors moves, bears, stores and dissipates as one of
// materials does, in small and in large strain.
TEST_P(ScatteredZonesOfEachKind, AreAsThoseOfMaterials) {
  constexpr double kRounding = 1e-8;
  const Grid grid = distorted_grid(kBlock);
  for (const bool large : {false, true})
    for (const Law& law : kLaws) {
      SCOPED_TRACE(std::string(law.name) + (large ? " large" : ""));
      const Ground factors = by_factors(law, grid, large), materials = by_materials(law, grid, large);
      Continuum found = shaken(GetParam(), grid, factors), wanted = shaken(GetParam(), grid, materials);
      const double dt = 0.8 * critical_step(GetParam(), grid, materials);
      Energies of_found{}, of_wanted{};
      for (std::uint64_t n = 0; n < 400; ++n) {
        found.step({n, dt}, &of_found);
        wanted.step({n, dt}, &of_wanted);
      }
      expect_same("uy", grid.x.size(), std::function([&](std::size_t i) { return found.uy()[i]; }),
                  std::function([&](std::size_t i) { return wanted.uy()[i]; }), kRounding);
      expect_same_zones(found.zones(), wanted.zones(), kRounding);
      EXPECT_NEAR(of_found.strain / of_wanted.strain, 1, kRounding);
      EXPECT_NEAR(of_found.dissipated, of_wanted.dissipated, kRounding * of_wanted.strain);
      EXPECT_EQ(of_wanted.dissipated > 0, !law.of(1, 1).linear());
    }
}

// Requirement: the same holds from the instant on at which zones with factors get another material: they bear
// what they bore.
TEST_P(ScatteredZonesOfEachKind, BearAsBeforeWhatTheyBoreAsAnotherMaterial) {
  const Grid grid = distorted_grid(kBlock);
  for (const Law& before : kLaws)
    for (const Law& after : kLaws) {
      SCOPED_TRACE(std::string(before.name) + " to " + after.name);
      Ground ground = by_factors(before, grid, false);
      ground.materials.push_back(after.of(1, 1));
      ZoneSet zones(GetParam(), grid, ground, ones(grid));
      const std::vector<double> still(grid.x.size(), 0.0);
      zones.follow(still.data(), still.data());
      std::vector<std::uint32_t> all;
      for (std::uint32_t z = 0; z < grid.zones.size(); ++z) {
        zones.set_stress(z, {-2e5, -3e5, 4e4});
        ground.of_zone[z] = 1;
        all.push_back(z);
      }
      const ZoneForces pull = zones.forces(7);
      zones.renew(GetParam(), grid, ground, all, still.data(), still.data());
      EXPECT_NEAR(zones.stress(7).xx, -2e5, 1e-8 * 2e5);
      EXPECT_NEAR(zones.stress(7).xy, 4e4, 1e-8 * 2e5);
      for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(zones.forces(7).x[c], pull.x[c], 1e-8 * 2e5);
    }
}

// Requirement: steps and waves follow the stiffness of each zone.
TEST_P(ScatteredZonesOfEachKind, HaveTheirOwnCriticalStepsAndWaveSpeeds) {
  const Grid grid = distorted_grid(kBlock);
  for (const Law& law : kLaws) {
    const Ground factors = by_factors(law, grid, false), materials = by_materials(law, grid, false);
    const auto found = zone_steps(GetParam(), grid, factors),
               wanted = zone_steps(GetParam(), grid, materials);
    for (std::size_t z = 0; z < found.size(); ++z) EXPECT_NEAR(found[z] / wanted[z], 1, 1e-12);
    EXPECT_NEAR(wave_speeds(factors).p / wave_speeds(materials).p, 1, 1e-12);
    EXPECT_NEAR(wave_speeds(factors).s / wave_speeds(materials).s, 1, 1e-12);
  }
}

}  // namespace
}  // namespace adit::fdm::test::scattered_zones_test
