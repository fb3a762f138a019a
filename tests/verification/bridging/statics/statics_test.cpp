// Requirement: continuum and particles come to rest together under gravity and initial stress, with the
// stress that one model alone has, also in the overlap. Shaken afterwards, they move as from any other state
// of rest.
#include "coupler/stepping/statics.hpp"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/overlaps.hpp"

namespace adit::statics_test {
namespace {

// A block of ground on rollers at its sides, fixed at its base, in plane strain.
constexpr double kWidth = 16, kHeight = 10, kZone = 0.5, kDensity = 2000, kGravity = 10, kPoisson = 0.2;
constexpr double kK0 = kPoisson / (1 - kPoisson);
const double kRadius = kHeight / (58 * std::numbers::sqrt3);  // rows that fill the height

constexpr const char* kGravityLoad = "body_loads { acceleration { y: -10 } } ";

std::string continuum(const std::string& more = kGravityLoad) {
  return fmt::format(
      "continuum {{ block {{ x_min: 0 x_max: {} y_min: 0 y_max: {} zones_x: {} zones_y: {} }} {} "
      "motions {{ where {{ x_max: 0 }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ x_min: {} }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ y_max: 0 }} velocity {{ x: 0 y: 0 }} }} }} ",
      kWidth, kHeight, std::lround(kWidth / kZone), std::lround(kHeight / kZone), more, kWidth);
}

std::string particles(double x_min, double x_max, double y_min, double y_max,
                      const std::string& more = kGravityLoad) {
  return fmt::format(
      "particles {{ packing {{ x_min: {} x_max: {} y_min: {} y_max: {} radius: {:.17g} }} {} }} ", x_min,
      x_max, y_min, y_max + 1e-9, kRadius, more);
}

// Rollers and base of particles that fill the width.
std::string rollers(double from) {
  return fmt::format(
      "{} motions {{ where {{ x_max: {} y_min: {} }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ x_min: {} y_min: {} }} velocity {{ x: 0 }} }} ",
      kGravityLoad, 2.5 * kRadius, from, kWidth - 2.5 * kRadius, from);
}

scene::Scene block(const std::string& models, double ratio = 1e-5, double young = 5e7) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      fmt::format("material {{ young_modulus: {} poisson_ratio: {} density: {} }} time {{ duration: 0.2 }} "
                  "statics {{ unbalanced_ratio: {} }} ",
                  young, kPoisson, kDensity, ratio) +
          models,
      &scene))
      << models;
  return scene;
}

std::string joined(const std::string& overlap) {
  return "interface { overlap { " + overlap + " } } ";
}
const std::string kCoupledByStrip =
    continuum() + particles(0, kWidth, 0, kHeight, rollers(6.01)) + joined(test::strip(8, 3, 8, 6));
std::string coupled_by_ring(const std::string& shape) {
  return continuum() + particles(2, 14, 0, kHeight) + joined(test::ring(shape, 2));
}

struct Settled {
  coupler::Model model;
  coupler::Stepper stepper{model};
  coupler::Rest rest;

  explicit Settled(const scene::Scene& scene) : model(test::local_model(scene)) {
    rest = relax(model, stepper);
  }
};

const wire::Field& field(const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                         const std::string& name) {
  for (const auto& candidate : fields)
    if (candidate.name() == name) return candidate;
  throw std::out_of_range(name);
}

// Stress as a share of what the weight above causes: 1 in equilibrium (its shear: 0).
struct Share {
  double xx = 0, yy = 0, xy = 0, weight = 0;  // sums over some zones or bonds, times their weights
};

double vertical(double y) {
  return -kDensity * kGravity * (kHeight - y);
}

void add(double y, double xx, double yy, double xy, double weight, Share& to) {
  to.xx += weight * xx / (kK0 * vertical(y));
  to.yy += weight * yy / vertical(y);
  to.xy += weight * xy / vertical(y);
  to.weight += weight;
}

constexpr int kColumns = static_cast<int>(kWidth), kRows = static_cast<int>(kHeight);
using Cells = std::array<std::array<Share, kColumns>, kRows>;  // square metres

Share& cell(Cells& cells, double x, double y) {
  return cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
}

void add_zones(const wire::Piece& grid, Cells& cells) {
  const auto &stress = field(grid.cell_fields(), "stress_Pa"), &weight = field(grid.cell_fields(), "weight");
  for (int z = 0; z < grid.connectivity_size() / 4; ++z) {
    double x = 0, y = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const int point = static_cast<int>(grid.connectivity(4 * z + corner));
      x += grid.points(2 * point) / 4;
      y += grid.points(2 * point + 1) / 4;
    }
    add(y, stress.values(3 * z), stress.values(3 * z + 1), stress.values(3 * z + 2), weight.values(z),
        cell(cells, x, y));
  }
}

// The stress of a lattice is the sum over its three directions of the mean of f ⊗ l / cell area.
void add_bonds(const wire::Piece& bonds, std::array<Cells, 3>& directions) {
  const auto &fn = field(bonds.cell_fields(), "normal_force_N"),
             &fs = field(bonds.cell_fields(), "shear_force_N"),
             &weight = field(bonds.cell_fields(), "weight");
  const double area = 2 * std::numbers::sqrt3 * kRadius * kRadius;
  for (int k = 0; k < bonds.connectivity_size() / 2; ++k) {
    const int i = static_cast<int>(bonds.connectivity(2 * k)),
              j = static_cast<int>(bonds.connectivity(2 * k + 1));
    const double lx = bonds.points(2 * j) - bonds.points(2 * i);
    const double ly = bonds.points(2 * j + 1) - bonds.points(2 * i + 1);
    const double nx = lx / (2 * kRadius), ny = ly / (2 * kRadius);
    const double fx = fn.values(k) * nx - fs.values(k) * ny, fy = fn.values(k) * ny + fs.values(k) * nx;
    const double x = bonds.points(2 * i) + lx / 2, y = bonds.points(2 * i + 1) + ly / 2;
    add(y, fx * lx / area, fy * ly / area, fx * ly / area, weight.values(k),
        cell(directions[ly < kRadius ? 0
                        : lx > 0     ? 1
                                     : 2],
             x, y));
  }
}

// What carries the load: the zones' mean with their weight, the particles' with the rest.
Cells carried(Settled& settled) {
  Cells cells{};
  std::array<Cells, 3> directions{};
  for (const auto& snapshot : settled.stepper.snapshots())
    for (const auto& piece : snapshot.pieces()) {
      if (piece.name() == "grid") add_zones(piece, cells);
      if (piece.name() == "bonds") add_bonds(piece, directions);
    }
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      Share& sum = cells[row][column];
      constexpr double kZones = 1 / (kZone * kZone);
      const double rest = 1 - sum.weight / kZones;
      sum = {sum.xx / kZones, sum.yy / kZones, sum.xy / kZones, 1};
      if (rest < 1e-9) continue;
      for (const Cells& direction : directions) {
        const Share& bonds = direction[row][column];
        if (bonds.weight == 0) continue;  // in corners of a ring, where the particles' weight ends
        sum.xx += rest * bonds.xx / bonds.weight;
        sum.yy += rest * bonds.yy / bonds.weight;
        sum.xy += rest * bonds.xy / bonds.weight;
      }
    }
  return cells;
}

double deviation(const Share& share) {
  return std::max({std::abs(share.xx - 1), std::abs(share.yy - 1), std::abs(share.xy)});
}

TEST(Statics, AContinuumAloneCarriesItsWeight) {
  Settled settled(block(continuum()));
  for (const auto& row : carried(settled))
    for (const Share& share : row) EXPECT_LE(deviation(share), 2e-4);
}

class CoupledStatics : public testing::TestWithParam<std::string> {};

TEST_P(CoupledStatics, CarryTheStressOfOneModel) {
  Settled settled(block(GetParam()));
  const Cells cells = carried(settled);
  // Above and at the sides of a strip the lattice's own edges, which lack half their bonds, disturb the
  // stress.
  const bool strip = GetParam() == kCoupledByStrip;
  for (int row = 0; row < (strip ? 7 : 8); ++row)
    for (int column = strip ? 6 : 0; column < (strip ? 10 : kColumns); ++column)
      EXPECT_LE(deviation(cells[row][column]), 0.01) << row << " " << column;
}

// Weight of all zones and particles, and what the zones above the base leave to it.
TEST_P(CoupledStatics, TheBaseCarriesTheWeight) {
  Settled settled(block(GetParam(), 1e-7));
  double weight = 0, base = 0;
  for (const auto& snapshot : settled.stepper.snapshots())
    for (const auto& piece : snapshot.pieces()) {
      if (piece.name() == "particles")
        for (const double share : field(piece.point_fields(), "weight").values())
          weight += share * dem::cell_mass(kDensity, kRadius) * kGravity;
      if (piece.name() != "grid") continue;
      const auto& shares = field(piece.cell_fields(), "weight");
      const double zone = kDensity * kZone * kZone * kGravity;
      for (int z = 0; z < shares.values_size(); ++z) {
        weight += shares.values(z) * zone;
        if (piece.points(2 * static_cast<int>(piece.connectivity(4 * z)) + 1) > 0) continue;
        base += zone / 2 - field(piece.cell_fields(), "stress_Pa").values(3 * z + 1) * kZone;
      }
    }
  EXPECT_NEAR(base, weight, 1e-6 * weight);
}

// What was at rest stays there when time begins, from displacements that are 0.
TEST_P(CoupledStatics, StayAtRest) {
  scene::Scene scene = block(GetParam(), 1e-6);
  for (auto* history :
       {scene.mutable_continuum()->add_histories(), scene.mutable_particles()->add_histories()}) {
    history->set_name(history == &scene.continuum().histories(0) ? "grid" : "particle");
    history->set_quantity(scene::DISPLACEMENT_Y);
    history->mutable_at()->set_x(8);
    history->mutable_at()->set_y(history == &scene.continuum().histories(0) ? 2 : 7);
  }
  Settled settled(scene);
  const double settlement = kDensity * kGravity * kHeight * kHeight / 2 / 5e7;
  for (std::uint64_t n = 0; n <= 300; ++n) {
    settled.stepper.step(n, {.energies = true, .histories = true});
    for (const auto& side : settled.model.participants) {
      const double displacement = side.prediction().histories(0);
      EXPECT_LE(std::abs(displacement), n == 0 ? 0 : 1e-5 * settlement);
    }
  }
  EXPECT_LE(settled.stepper.ledger().max_drift(), 1e-12);
}

// Requirement: what the ground weighs and what it was given as initial stress are the same: it hardly moves.
TEST_P(CoupledStatics, InitialStressBalancesTheWeight) {
  const auto settle = [](const std::string& models) {
    Settled settled(block(models));
    double squares = 0;
    for (const auto& snapshot : settled.stepper.snapshots())
      for (const double u : field(snapshot.pieces(0).point_fields(), "displacement_m").values())
        squares += u * u;
    return std::sqrt(squares);
  };
  const double weight = kDensity * kGravity;
  const std::string initial =
      fmt::format("initial_stress {{ yy: {} yy_per_metre: {} xx: {} xx_per_metre: {} }} ", -weight * kHeight,
                  weight, -kK0 * weight * kHeight, kK0 * weight);
  EXPECT_LE(settle(initial + GetParam()), 0.02 * settle(GetParam()));
  EXPECT_LE(settle(initial + continuum()), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(StripAndRings, CoupledStatics,
                         testing::Values(kCoupledByStrip, coupled_by_ring(test::box(6, 10, 3, 7)),
                                         coupled_by_ring(test::circle(8, 5, 2.2))));

// Requirement: initial stress that nothing holds is released by the strain -C⁻¹ σ: here under tension along
// x. The discs at two corners cannot bear their part, and their neighbours take it over: a share of the area
// that falls with that of a disc.
TEST(Statics, FreeInitialStressIsReleased) {
  const double young = 5e10, stress = 1e4, strain = stress * (1 - kPoisson * kPoisson) / young;
  const auto held = [](double reach) {
    return fmt::format(
        "motions {{ where {{ x_max: {} }} velocity {{ x: 0 }} }} "
        "motions {{ where {{ x_max: {} y_max: {} }} velocity {{ y: 0 }} }} ",
        reach, reach, reach);
  };
  const std::string initial = fmt::format("initial_stress {{ xx: {} }} ", stress);
  for (const std::string& model :
       {"continuum { block { x_min: 0 x_max: 8 y_min: 0 y_max: 4 zones_x: 8 zones_y: 4 } " + held(0) + "} ",
        "particles { packing { x_min: 0 x_max: 8 y_min: 0 y_max: 4 radius: 0.1 } " + held(0.175) + "} "}) {
    Settled settled(block(initial + model, 1e-6, young));
    for (const auto& snapshot : settled.stepper.snapshots()) {
      const auto& piece = snapshot.pieces(0);
      const auto& u = field(piece.point_fields(), "displacement_m").values();
      const int last = piece.points_size() / 2 - 1;
      for (int i = 0; i <= last; i += last) {
        EXPECT_NEAR(u[3 * i] - u[0], -strain * (piece.points(2 * i) - piece.points(0)), 1e-4 * strain * 8);
        EXPECT_NEAR(u[3 * i + 1] - u[1],
                    strain * kPoisson / (1 - kPoisson) * (piece.points(2 * i + 1) - piece.points(1)),
                    1e-4 * strain * 8);
      }
    }
  }
}

// Requirement: small motions do not know of the stress that they start from.
TEST(Statics, ShakenGroundMovesAsWithoutWeight) {
  const auto top = [](const std::string& load) {
    const std::string history = "histories { name: 'top' quantity: DISPLACEMENT_Y at { x: 8 y: 10 } } ";
    scene::Scene scene = block(continuum(load + history) + particles(2, 14, 0, kHeight, load) +
                                   joined(test::ring(test::box(6, 10, 3, 7), 2)),
                               1e-6, 5e11);
    auto& base = *scene.mutable_continuum()->mutable_motions(2);
    base.mutable_velocity()->set_y(0.1);
    base.mutable_time()->mutable_sine()->set_frequency(200);
    scene.mutable_time()->set_duration(0.005);
    if (load.empty()) scene.clear_statics();
    coupler::Model model = test::local_model(scene);
    coupler::Stepper stepper(model);
    if (scene.has_statics()) relax(model, stepper);
    std::vector<double> displacements;
    for (std::uint64_t n = 0; n <= model.steps; ++n) {
      stepper.step(n, {.energies = true, .histories = true});
      displacements.push_back(model.participants[0].prediction().histories(0));
    }
    EXPECT_LE(stepper.ledger().max_drift(), 1e-6);
    return displacements;
  };
  const auto with = top(kGravityLoad), without = top("");
  const double largest =
      std::abs(*std::ranges::max_element(without, {}, [](double u) { return std::abs(u); }));
  ASSERT_GT(largest, 1e-5);
  for (std::size_t n = 0; n < with.size(); ++n) ASSERT_NEAR(with[n], without[n], 1e-6 * largest) << n;
}

// Requirement: a model that does not come to rest ends the run and says what to change.
TEST(Statics, TooFewStepsEndTheRun) {
  scene::Scene scene = block(kCoupledByStrip);
  scene.mutable_statics()->set_max_steps(20);
  try {
    Settled settled(scene);
    FAIL() << "rests";
  } catch (const protocol::UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("after 20 steps the unbalanced force ratio is"));
  }
}

}  // namespace
}  // namespace adit::statics_test
