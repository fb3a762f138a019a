// Requirements on what lies beyond the grid: the ledger of every boundary, rest, plane waves beside the free
// field.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "tests/unit/fdm_server/boundaries/boundary_scenes.hpp"

namespace adit::fdm::test::boundaries_test {
namespace {

const std::string kBlock = "block { x_min: 0 x_max: 12 y_min: -8 y_max: 0 zones_x: 12 zones_y: 8 } ";
const std::string kRicker = "acceleration { ricker { frequency: 8 time: 0.15 } peak: 2 } ";
const std::string kSides = "free_field { left: true right: true } ";
const std::string kPulse =
    "edge_loads { where { x_min: 4 x_max: 7 y_min: 0 } force { x: 3e4 y: -1e5 } time { table { time: 0 time: "
    "0.02 "
    "time: 0.04 value: 0 value: 1 value: 0 } } } ";
const std::string kWeight = "body_loads { acceleration { y: -10 } } ";
// sxx = K0 syy with K0 = nu/(1 - nu), as the weight of wide ground causes it.
const std::string kAtRest = "initial_stress { yy_per_metre: 2e4 xx_per_metre: 6666.666666666667 } ";

struct Case {
  std::string name, continuum, others;
};

const std::vector<Case> kCases = {
    {"quiet",
     "quiet { where { y_max: -8 } } quiet { where { x_max: 0 } shear: false } quiet { where { x_min: 12 } "
     "} " +
         kPulse,
     ""},
    {"rigid_base", "base { " + kRicker + "} ", ""},
    {"rigid_base_upwards",
     "base { direction: Y velocity { amplitude: 0.1 time { sine { frequency: 9 } } } } ", ""},
    {"compliant_base", "base { kind: COMPLIANT " + kRicker + "} " + kPulse, ""},
    {"stress", "base { kind: COMPLIANT stress { amplitude: 1e4 time { sine { frequency: 9 end: 0.2 } } } } ",
     ""},
    {"free_field", kSides + "base { kind: COMPLIANT " + kRicker + "} " + kPulse, ""},
    {"free_field_rigid", kSides + "base { " + kRicker + "} " + kPulse, ""},
    {"travelling",
     kSides + "base { kind: COMPLIANT " + kRicker +
         "incidence { apparent_velocity: 500 coherency { drift: 3e-4 } } } ",
     ""},
    {"at_rest", kSides + kWeight + "base { kind: COMPLIANT direction: Y " + kRicker + "} ", kAtRest},
    {"rayleigh",
     kSides + kPulse + "base { kind: COMPLIANT " + kRicker +
         "} damping { rayleigh { ratio: 0.05 low_frequency: 3 high_frequency: 20 } } ",
     ""},
    {"maxwell",
     kSides + kPulse + "base { kind: COMPLIANT " + kRicker +
         "} damping { maxwell { ratio: 0.05 low_frequency: 3 high_frequency: 20 } } ",
     ""},
    {"local", kPulse + "base { " + kRicker + "} damping { local { alpha: 0.2 } } ", ""},
};

class BoundaryOf : public testing::TestWithParam<std::tuple<Case, std::string>> {};
INSTANTIATE_TEST_SUITE_P(Kinds, BoundaryOf,
                         testing::Combine(testing::ValuesIn(kCases),
                                          testing::Values("", "zone: MIXED_DISCRETIZATION ")),
                         [](const auto& test) {
                           return std::get<0>(test.param).name +
                                  (std::get<1>(test.param).empty() ? "" : "_flac");
                         });

// Kinetic + strain + dissipated - work keeps its first value to 1e-10 of the largest energy.
TEST_P(BoundaryOf, LedgerCloses) {
  const auto& [scene, zone] = GetParam();
  GroundRun run(kBlock + zone + scene.continuum, 0.5, 0.8, scene.others);
  double first = 0, peak = 0, drift = 0;
  for (std::uint64_t n = 0; n <= run.steps(); ++n) {
    const auto& e = run.advance().energies();
    const double ledger = e.kinetic() + e.strain() + e.dissipated() - e.external_work();
    if (n == 0) first = ledger;
    peak = std::max({peak, std::abs(e.kinetic()), std::abs(e.external_work())});
    drift = std::max(drift, std::abs(ledger - first));
  }
  EXPECT_GT(peak, 0);
  EXPECT_LE(drift, 1e-10 * peak);
}

// Without load or damping a quiet boundary takes energy and never gives any: what kinetic and strain energy
// hold grows in no step by more than 1e-10 of it.
TEST(QuietBoundary, EnergyNeverGrows) {
  GroundRun run(kBlock + "quiet { where {} } " + kPulse, 0.4, 0.9);
  double before = HUGE_VAL;
  double first = 0, last = 0;
  for (std::uint64_t n = 0; n <= run.steps(); ++n) {
    const auto& e = run.advance().energies();
    last = e.kinetic() + e.strain();
    if (static_cast<double>(n) * run.dt > 0.041) {
      ASSERT_LE(last, before + 1e-10 * first) << n;
    } else {
      first = std::max(first, last);
    }
    before = last;
  }
  EXPECT_LT(last, 1e-4 * first);
}

// The limit of the time step is that of the grid without dashpots: the roughest motion dies at 0.999 of it.
TEST(QuietBoundary, DoesNotShortenTheCriticalStep) {
  for (const std::string zone : {"", "zone: MIXED_DISCRETIZATION "}) {
    GroundRun run(kBlock + zone + kSides +
                      "quiet { where { y_max: -8 } } point_loads { where { x_max: 3 y_min: -1 } "
                      "force { x: 1e6 y: 3e5 } time { table { time: 0 time: 1e-3 value: 1 value: 0 } } }",
                  3, 0.999);
    double largest = 0, last = 0;
    for (std::uint64_t n = 0; n <= run.steps(); ++n) {
      const auto& e = run.advance().energies();
      last = e.kinetic() + e.strain();
      largest = std::max(largest, last);
    }
    EXPECT_LT(last, 1e-3 * largest);
  }
}

// The ground above a compliant base takes the velocity of the outcrop, also its sign: where that rises to a
// constant, all ground moves with it in the end.
TEST(CompliantBase, MovesTheGroundAsItsOutcrop) {
  for (const std::string direction : {"X", "Y"}) {
    GroundRun run(kBlock + kSides + "base { kind: COMPLIANT direction: " + direction +
                      " velocity { amplitude: 0.1 time { table { time: [0, 0.05] value: [0, 1] } } } } "
                      "histories { name: 'top' quantity: VELOCITY_" +
                      direction + " at { x: 6 y: 0 } } ",
                  0.5);
    for (std::uint64_t n = 0; n < run.steps(); ++n) run.advance();
    EXPECT_NEAR(run.predicted.histories(0), 0.1, 1e-3) << direction;
  }
}

// Both components of the velocity of all points, by height: how far the rows are from moving alike.
double unevenness(const wire::Snapshot& snapshot) {
  const auto& piece = snapshot.pieces(0);
  const auto& v = piece.point_fields(1).values();
  std::map<double, std::array<double, 4>> rows;
  double largest = 0, spread = 0;
  for (int i = 0; i < piece.points_size() / 2; ++i) {
    auto& row = rows.try_emplace(piece.points(2 * i + 1), std::array{1e9, -1e9, 1e9, -1e9}).first->second;
    for (int c = 0; c < 2; ++c) {
      row[2 * c] = std::min(row[2 * c], v[3 * i + c]);
      row[2 * c + 1] = std::max(row[2 * c + 1], v[3 * i + c]);
      largest = std::max(largest, std::abs(v[3 * i + c]));
    }
  }
  for (const auto& [y, row] : rows) spread = std::max({spread, row[1] - row[0], row[3] - row[2]});
  return spread / largest;
}

// A vertical wave beside free fields stays plane to 1 %: here to rounding, shear and pressure, damped or not.
TEST(FreeField, VerticalWaveStaysPlane) {
  for (const std::string zone : {"", "zone: MIXED_DISCRETIZATION "})
    for (const std::string direction : {"X", "Y"})
      for (const std::string kind : {"RIGID", "COMPLIANT"})
        for (const std::string damping :
             {"", "damping { rayleigh { ratio: 0.05 low_frequency: 3 high_frequency: 20 } } ",
              "damping { maxwell { ratio: 0.05 low_frequency: 3 high_frequency: 20 } } "}) {
          GroundRun run(kBlock + zone + kSides + damping + "base { kind: " + kind +
                            " direction: " + direction + " " + kRicker + "} ",
                        0.3, 0.8);
          double worst = 0;
          for (std::uint64_t n = 0; n <= run.steps(); ++n) {
            run.advance();
            if (n % 20 == 0 && n > run.steps() / 3) worst = std::max(worst, unevenness(run.snapshot()));
          }
          EXPECT_LT(worst, 1e-9) << zone << direction << kind << damping;
        }
}

// Ground at rest under its weight on a compliant base, between free fields, stays at rest, whether statics
// found the stresses or the scene gives them.
TEST(FreeField, GroundAtRestStays) {
  const std::string ground = kBlock + kSides + kWeight +
                             "base { kind: COMPLIANT acceleration { ricker { frequency: 8 time: 1 } } } ";
  GroundRun given(ground, 0.2, 0.8, kAtRest), found(ground, 0.2, 0.8, "statics {} ");
  found.rest(8000);
  for (GroundRun* run : {&given, &found}) {
    double largest = 0;
    for (std::uint64_t n = 0; n <= run->steps(); ++n) run->advance();
    const auto snapshot = run->snapshot();
    for (const double u : snapshot.pieces(0).point_fields(0).values())
      largest = std::max(largest, std::abs(u));
    EXPECT_LT(largest, 1e-7);  // under its weight it settles by millimetres
    const auto& stress = snapshot.pieces(0).cell_fields(0).values();
    EXPECT_NEAR(stress[1], -150e3, 1e3);
    EXPECT_NEAR(stress[0], -50e3, 1e3);
  }
}

// The same under a load on the surface that stands for ground above the model: the columns bear it, too.
TEST(FreeField, GroundAtRestUnderALoadOnItsSurfaceStays) {
  GroundRun run(kBlock + kSides + kWeight +
                    "edge_loads { where { y_min: 0 } force { y: -1.2e6 } } "  // 100 kPa
                    "base { kind: COMPLIANT acceleration { ricker { frequency: 8 time: 1 } } } ",
                0.2, 0.8,
                "initial_stress { yy: -1e5 yy_per_metre: 2e4 xx: -33333.33333333333 "
                "xx_per_metre: 6666.666666666667 } ");
  double largest = 0;
  for (std::uint64_t n = 0; n <= run.steps(); ++n) run.advance();
  const auto snapshot = run.snapshot();
  for (const double u : snapshot.pieces(0).point_fields(0).values()) largest = std::max(largest, std::abs(u));
  EXPECT_LT(largest, 1e-7);
}

// Where an overlap leaves the grid a part of the weight everywhere, its sides and its base push with that
// part too: it rests and moves as the whole ground.
TEST(FreeField, PartOfTheWeightMovesAsTheWhole) {
  const std::string ground = kBlock + kSides + kWeight + "base { kind: COMPLIANT " + kRicker +
                             "} histories { name: 'a' quantity: VELOCITY_X at { x: 3 y: 0 } } "
                             "histories { name: 'b' quantity: STRESS_XX at { x: 0.5 y: -4.5 } } ";
  GroundRun whole(ground, 0.3, 0.8, kAtRest), part(ground, 0.3, 0.8, kAtRest, 0.3);
  std::array<double, 2> largest{}, difference{};
  for (std::uint64_t n = 0; n <= whole.steps(); ++n) {
    whole.advance();
    part.advance();
    for (int q = 0; q < 2; ++q) {
      const double a = whole.predicted.histories(q), b = part.predicted.histories(q);
      largest[q] = std::max(largest[q], std::abs(a));
      difference[q] = std::max(difference[q], std::abs(a - b));
    }
  }
  for (int q = 0; q < 2; ++q) {
    EXPECT_GT(largest[q], 0);
    EXPECT_LT(difference[q], 1e-9 * largest[q]);
  }
}

// Splitting the points by an interface changes nothing but the order of sums, also where it cuts the grid's
// sides.
TEST(FreeField, InterfaceDividesNoPhysics) {
  const std::string ground = kBlock + kSides + kPulse + "base { kind: COMPLIANT " + kRicker +
                             "} histories { name: 'a' quantity: VELOCITY_X at { x: 3 y: 0 } } ";
  GroundRun whole(ground, 0.3, 0.8), divided(ground, 0.3, 0.8);
  wire::Couple couple;
  for (const double x : {0.0, 0.5, 3.25, 12.0})
    for (const double y : {0.0, -2.5, -8.0}) {
      couple.add_points(x);
      couple.add_points(y);
    }
  wire::Operator op;
  divided.participant.couple(couple, op);
  double largest = 0, difference = 0;
  for (std::uint64_t n = 0; n <= whole.steps(); ++n) {
    const double a = whole.advance().histories(0), b = divided.advance().histories(0);
    largest = std::max(largest, std::abs(a));
    difference = std::max(difference, std::abs(a - b));
  }
  EXPECT_LT(difference, 1e-11 * largest);
}

}  // namespace
}  // namespace adit::fdm::test::boundaries_test
