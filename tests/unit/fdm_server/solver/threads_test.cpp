// Requirements on the division of a step among threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test::threads_test {
namespace {

const PlaneLaw kLaw = plane_strain(kYoung, kPoisson);

enum class Order { kRows, kShuffled };
enum class Solid { kElastic, kYielding, kScattered };

struct Variant {
  ZoneKind kind;
  Order order;
  bool interface;
  Solid solid = Solid::kElastic;
};

// Grids of several chunks. Shuffled zones are runs of one, and all chunks share nearly all points.
Grid variant_grid(Order order) {
  if (order == Order::kRows) return make_grid({0, 150, 0, 20, 300, 60});
  Grid grid = distorted_grid({0, 75, 0, 30, 150, 100});
  std::shuffle(grid.zones.begin(), grid.zones.end(), std::mt19937(1));
  return grid;
}

// Elastic zones, zones that yield at once and hysteretic ones of both memories, in columns of three zones;
// scattered: each as stiff and as strong as no other one.
Ground yielding_ground(const Grid& grid, bool scattered) {
  const Material elastic{kDensity, kYoung, kPoisson};
  Ground ground{{elastic, elastic, elastic, elastic}, {}};
  ground.materials[1].mohr_coulomb = MohrCoulomb({1e3, 0.5, 0.1, 5e2});
  ground.materials[2].hysteretic = iwan_elements(backbone(hyperbola(1e-5, 1), 1e-7, 1e-4, 10));
  ground.materials[3].reversals = Polyline(backbone(hyperbola(1e-5, 1), 1e-7, 1e-4, 10));
  for (std::size_t z = 0; z < grid.zones.size(); ++z)
    ground.of_zone.push_back(static_cast<std::uint32_t>(corners(grid, z).x[0] / 1.5) % 4);
  for (std::size_t z = 0; scattered && z < grid.zones.size(); ++z) {
    ground.stiffness_factor.push_back(0.9 + 0.1 * std::sin(static_cast<double>(z)));
    ground.strength_factor.push_back(1 + 0.5 * std::cos(static_cast<double>(z)));
  }
  return ground;
}

ZoneSet variant_zones(const Variant& variant, const Grid& grid, std::span<const double> weights) {
  if (variant.solid == Solid::kElastic) return {variant.kind, grid, kLaw, weights};
  return {variant.kind, grid, yielding_ground(grid, variant.solid == Solid::kScattered), weights};
}

struct Motions {
  std::vector<double> ux, uy, vx, vy;
  Energies energies;
  bool operator==(const Motions& other) const {
    return ux == other.ux && uy == other.uy && vx == other.vx && vy == other.vy &&
           energies.kinetic == other.energies.kinetic && energies.strain == other.energies.strain &&
           energies.external_work == other.energies.external_work &&
           energies.dissipated == other.energies.dissipated;
  }
};

// A weighted block hangs on its left side and is hit on some points of every chunk.
Motions shaken(const Variant& variant, const Grid& grid, std::size_t threads, bool in_halves = false) {
  std::vector<double> weights(grid.zones.size());
  for (std::size_t z = 0; z < weights.size(); ++z)
    weights[z] = std::min(1.0, 0.2 + 0.01 * corners(grid, z).x[0]);
  Load hit{{}, {}, {}, [](double t) { return std::cos(500 * t); }};
  PrescribedMotion fixed{{}, Axis::kX, 0.0, [](double) { return 1.0; }};
  std::vector<std::uint32_t> interface;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    if (i % 701 == 0) hit.points.push_back(i);
    if (grid.x[i] == 0) fixed.points.push_back(i);
    if (std::abs(grid.x[i] - 30) < 4) interface.push_back(i);
  }
  hit.fx.assign(hit.points.size(), 1e6);
  hit.fy.assign(hit.points.size(), -2e6);
  Continuum continuum(variant_zones(variant, grid, weights), lumped_masses(grid, weights, kDensity), {hit},
                      {fixed}, threads);
  if (variant.interface) continuum.set_interface(interface);
  const double dt = 0.8 * critical_step(variant.kind, make_grid({0, 0.3, 0, 0.2, 1, 1}), kLaw, kDensity);
  Energies energies{};
  for (std::uint64_t n = 0; n < 40; ++n)
    if (in_halves && n != 39) {
      continuum.step_interface({n, dt});
      continuum.step_interior({n, dt});
    } else {
      continuum.step({n, dt}, &energies);
    }
  const auto copy = [](std::span<const double> column) { return std::vector(column.begin(), column.end()); };
  return {copy(continuum.ux()), copy(continuum.uy()), copy(std::as_const(continuum).vx()),
          copy(std::as_const(continuum).vy()), energies};
}

constexpr const char* kSolids[] = {"", "Yielding", "Scattered"};

class Threads : public testing::TestWithParam<Variant> {};
INSTANTIATE_TEST_SUITE_P(
    Variants, Threads,
    testing::Values(Variant{ZoneKind::kAssumedStrain, Order::kRows, false},
                    Variant{ZoneKind::kMixedDiscretization, Order::kRows, true},
                    Variant{ZoneKind::kAssumedStrain, Order::kShuffled, true},
                    Variant{ZoneKind::kAssumedStrain, Order::kRows, true, Solid::kYielding},
                    Variant{ZoneKind::kMixedDiscretization, Order::kShuffled, false, Solid::kYielding},
                    Variant{ZoneKind::kAssumedStrain, Order::kRows, false, Solid::kScattered}),
    [](const auto& variant) {
      return std::string(kSolids[static_cast<int>(variant.param.solid)]) +
             (variant.param.order == Order::kRows ? "Rows" : "Shuffled") +
             (variant.param.interface ? "WithInterface" : "");
    });

// Displacements, velocities and energies do not differ by a bit, whatever the number of threads.
TEST_P(Threads, ChangeNoBit) {
  const Grid grid = variant_grid(GetParam().order);
  const Motions one = shaken(GetParam(), grid, 1);
  EXPECT_GT(one.energies.strain, 0);
  EXPECT_EQ(one.energies.dissipated > 0, GetParam().solid != Solid::kElastic);
  for (const std::size_t threads : {2u, 3u, 4u})
    EXPECT_TRUE(shaken(GetParam(), grid, threads) == one) << threads;
}

// A step in two halves is the step, to the bit, also where several threads compute each.
TEST_P(Threads, HalvesOfAStepAreTheStep) {
  const Grid grid = variant_grid(GetParam().order);
  const Motions whole = shaken(GetParam(), grid, 2), halves = shaken(GetParam(), grid, 2, true);
  EXPECT_EQ(whole.vx, halves.vx);
  EXPECT_EQ(whole.uy, halves.uy);
}

// The order of zones, and with it how they are divided, changes the rounding of sums and nothing else.
TEST(Chunks, ChangeNoPhysics) {
  const Grid rows = make_grid({0, 75, 0, 50, 150, 100});
  Grid shuffled = rows;
  std::shuffle(shuffled.zones.begin(), shuffled.zones.end(), std::mt19937(2));
  const Variant variant{ZoneKind::kAssumedStrain, Order::kRows, false};
  const Motions a = shaken(variant, rows, 1), b = shaken(variant, shuffled, 2);
  double largest = 0;
  for (const double v : a.vx) largest = std::max(largest, std::abs(v));
  EXPECT_GT(largest, 0);
  for (std::size_t i = 0; i < a.vx.size(); ++i) EXPECT_NEAR(a.vx[i], b.vx[i], 1e-12 * largest);
  EXPECT_NEAR(a.energies.strain, b.energies.strain, 1e-12 * a.energies.strain);
}

}  // namespace
}  // namespace adit::fdm::test::threads_test
