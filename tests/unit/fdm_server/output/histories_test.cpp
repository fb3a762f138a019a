// Requirements on histories: what they say at any place, measured against closed forms.
#include "fdm_server/output/histories.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"
#include "tests/unit/fdm_server/solver/standing_wave.hpp"

namespace adit::fdm::test::histories_test {
namespace {

using Values = google::protobuf::RepeatedField<double>;

constexpr std::array kQuantities = {scene::DISPLACEMENT_X, scene::DISPLACEMENT_Y, scene::VELOCITY_X,
                                    scene::VELOCITY_Y,     scene::ACCELERATION_X, scene::ACCELERATION_Y,
                                    scene::STRESS_XX,      scene::STRESS_YY,      scene::STRESS_XY,
                                    scene::STRAIN_XX,      scene::STRAIN_YY,      scene::SHEAR_STRAIN_XY};
using Figures = std::array<double, kQuantities.size()>;

std::vector<std::uint32_t> one_kind(const Grid& grid) {
  return std::vector<std::uint32_t>(grid.zones.size(), 0);
}

// Places all over the box, without symmetry; or on its boundary.
std::vector<std::array<double, 2>> places(bool on_boundary) {
  constexpr double kGolden = 0.6180339887498949, kRoot = 0.4142135623730951;
  std::vector<std::array<double, 2>> places;
  for (int i = 1; i <= 200; ++i) {
    const double x = std::fmod(i * kGolden, 1), y = std::fmod(i * kRoot, 1);
    places.push_back({StandingWave::kWidth * (on_boundary && i % 2 ? std::round(x) : x),
                      StandingWave::kHeight * (on_boundary && !(i % 2) ? std::round(y) : y)});
  }
  return places;
}

Figures figures(const StandingWave::State& s, const StandingWave::State& half_before) {
  return {s.ux, s.uy, half_before.vx, half_before.vy, s.ax, s.ay, s.sxx, s.syy, s.sxy, s.exx, s.eyy, s.gxy};
}

// Each quantity's error, as a share of its values over the box (root mean squares).
struct Errors {
  Figures inside{}, on_boundary{};
};

Errors errors(ZoneKind kind, std::uint32_t zones_y) {
  const StandingWave wave;
  const Grid grid = make_grid(StandingWave::block(zones_y));
  const double end = 0.35 * 2 * std::numbers::pi / wave.w;  // neither displacement nor velocity is 0 there
  const double steps = std::ceil(end / (0.7 * critical_step(kind, grid, wave.law, kDensity))),
               dt = end / steps;
  const auto continuum = wave.start(kind, grid, dt);
  scene::Continuum scene;
  for (const bool on_boundary : {false, true})
    for (const auto& [x, y] : places(on_boundary))
      for (const auto quantity : kQuantities) {
        auto& history = *scene.add_histories();
        history.set_quantity(quantity);
        history.mutable_at()->set_x(x);
        history.mutable_at()->set_y(y);
      }
  Histories histories(scene, {}, grid, one_kind(grid), {}, DampingLaw{});
  protocol::Step step{0, dt};
  while (static_cast<double>(step.number) < steps) {
    ++step.number;
    histories.remember(*continuum);
    continuum->step(step);
  }
  Values values;
  histories.read(grid, {}, *continuum, step, values);
  Errors errors;
  Figures size{};
  int next = 0;
  for (const bool on_boundary : {false, true})
    for (const auto& [x, y] : places(on_boundary)) {
      const Figures exact = figures(wave.at(x, y, end), wave.at(x, y, end - dt / 2));
      for (std::size_t q = 0; q < exact.size(); ++q) {
        (on_boundary ? errors.on_boundary : errors.inside)[q] += std::pow(values[next++] - exact[q], 2);
        if (!on_boundary) size[q] += std::pow(exact[q], 2);
      }
    }
  for (Figures* error : {&errors.inside, &errors.on_boundary})
    for (std::size_t q = 0; q < size.size(); ++q) (*error)[q] = std::sqrt((*error)[q] / size[q]);
  return errors;
}

// Everywhere, every quantity converges with order 2 to the closed form of a standing wave, on both kinds of
// zones; with 128 zones to the shorter wavelength it is within 1e-3 of its size inside, and within 2e-3 on
// the boundary.
TEST(Histories, AreOfSecondOrderAnywhere) {
  for (const ZoneKind kind : kKinds) {
    const Errors coarse = errors(kind, 32), middle = errors(kind, 64), fine = errors(kind, 128);
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      SCOPED_TRACE(protocol::name_of(kQuantities[q]));
      for (const auto place : {&Errors::inside, &Errors::on_boundary}) {
        EXPECT_GT(std::log2((coarse.*place)[q] / (middle.*place)[q]), 1.9);
        EXPECT_GT(std::log2((middle.*place)[q] / (fine.*place)[q]), 1.9);
      }
      EXPECT_LT(fine.inside[q], 1e-3);
      EXPECT_LT(fine.on_boundary[q], 2e-3);
    }
  }
}

// Uniform strain is found to rounding anywhere in a distorted grid.
TEST(Histories, FindUniformStrainInADistortedGrid) {
  const Grid grid = distorted_grid({0, 3, 0, 2, 12, 8});
  for (const auto& [x, y] : {std::pair{1.234, 0.567}, {0.1, 0.1}, {2.99, 1.99}, {0.0, 1.0}}) {
    for (std::uint32_t zone : {0u, 40u, 95u}) {
      const ZoneShares fit = fit_around(grid, one_kind(grid), zone, x, y);
      double sum = 0, linear = 0;
      for (std::size_t k = 0; k < fit.zones.size(); ++k) {
        const Corners c = corners(grid, fit.zones[k]);
        // the mean of x over a zone: by Green's theorem
        double moment = 0;
        for (std::size_t a = 0; a < 4; ++a) {
          const std::size_t b = (a + 1) % 4;
          moment += (c.x[a] * c.y[b] - c.x[b] * c.y[a]) * (c.x[a] + c.x[b]) / 6;
        }
        sum += fit.shares[k];
        linear += fit.shares[k] * moment / area(c);
      }
      EXPECT_NEAR(sum, 1, 1e-13);
      EXPECT_NEAR(linear, x, 1e-12);
    }
  }
}

// A column one zone wide has a slope along it and none across.
TEST(Histories, FitAColumnOfZones) {
  const Grid grid = make_grid({0, 1, 0, 4, 1, 4});
  const ZoneShares fit = fit_around(grid, one_kind(grid), 1, 0.9, 1.75);
  double height = 0, sum = 0;
  for (std::size_t k = 0; k < fit.zones.size(); ++k) {
    height += fit.shares[k] * (fit.zones[k] + 0.5);
    sum += fit.shares[k];
  }
  EXPECT_NEAR(height, 1.75, 1e-13);
  EXPECT_NEAR(sum, 1, 1e-13);
  const Grid alone = make_grid({0, 1, 0, 1, 1, 1});
  EXPECT_EQ(fit_around(alone, one_kind(alone), 0, 0.3, 0.2).shares, std::vector<double>{1});
}

// Across the edge between two kinds of ground nothing is smoothed: the fit takes zones of one kind only.
TEST(Histories, FitStaysInOneKindOfGround) {
  const Grid grid = make_grid({0, 3, 0, 4, 3, 4});
  std::vector<std::uint32_t> kinds(12, 0);
  std::fill(kinds.begin() + 6, kinds.end(), 1);  // the upper half
  for (const auto& [zone, y] : {std::pair{4u, 1.9}, {7u, 2.1}}) {
    const ZoneShares fit = fit_around(grid, kinds, zone, 1.4, y);
    for (const auto other : fit.zones) EXPECT_EQ(kinds[other], kinds[zone]);
    EXPECT_EQ(fit.zones.size(), 6u);
  }
}

// Two layers that are stretched alike, each point as it is told: beside their joint, on either side, the
// stress is the layer's own, E / (1 - nu^2) times the strain.
TEST(Histories, StressBesideAJointIsEachLayersOwn) {
  constexpr double kSoft = 1e9, kStiff = 4e9, kNu = 0.2;
  for (const auto& [lower, upper] : {std::pair{kSoft, kStiff}, {kStiff, kSoft}}) {
    std::string scene = fmt::format(
        "material {{ young_modulus: {} poisson_ratio: {} density: 2500 }} materials {{ where {{ y_min: 0.5 "
        "}} "
        "material {{ young_modulus: {} poisson_ratio: {} density: 2500 }} }} ",
        lower, kNu, upper, kNu);
    for (int column = 0; column <= 12; ++column)
      scene += fmt::format("motions {{ where {{ x_min: {} x_max: {} }} velocity {{ x: {} y: 0 }} }} ",
                           0.5 * column - 0.1, 0.5 * column + 0.1, 1e-2 * column);
    for (const double y : {0.49, 0.51})
      scene += fmt::format("histories {{ name: 'stress' quantity: STRESS_XX at {{ x: 3.1 y: {} }} }} ", y);
    Conversation run(scene);
    const double dt = run.model.critical_dt() / 2;
    for (std::uint64_t n = 0; n <= 100; ++n) run.advance(n, dt);
    const double strain = 2e-2 * 100 * dt;
    EXPECT_NEAR(run.predicted.histories(0) / (lower / (1 - kNu * kNu) * strain), 1, 1e-9);
    EXPECT_NEAR(run.predicted.histories(1) / (upper / (1 - kNu * kNu) * strain), 1, 1e-9);
  }
}

// Where the ground is taken away nothing is recorded, and the refusal says why and names a place that stays;
// at its wall, the zone that stays.
TEST(Histories, AreOfGroundThatStays) {
  const Grid grid = make_grid({0, 3, 0, 1, 3, 1});
  const std::vector<std::uint32_t> kinds{kNoGround, 0, 0};
  scene::Continuum scene;
  auto& history = *scene.add_histories();
  history.set_quantity(scene::STRESS_XX);
  history.mutable_at()->set_x(1);
  history.mutable_at()->set_y(0.5);
  EXPECT_NO_THROW(Histories(scene, {}, grid, kinds, {}, DampingLaw{}));
  history.mutable_at()->set_x(0);
  adit::test::expect_refusal(
      [&] { Histories(scene, {}, grid, kinds, {}, DampingLaw{}); }, "continuum.histories[0].at",
      "is (0, 0.5) m, in a zone that continuum.excavations take away; the nearest grid "
      "point of ground that stays is (1, 0) m");
  history.mutable_at()->set_x(-2);
  adit::test::expect_refusal([&] { Histories(scene, {}, grid, kinds, {}, DampingLaw{}); },
                             "continuum.histories[0].at", "is (-2, 0.5) m, where the continuum has no zone");
}

// The stress across the plane is that of plane strain, nu (sxx + syy), and 0 in plane stress.
TEST(Histories, KnowTheStressAcrossThePlane) {
  for (const bool plane_strain : {true, false}) {
    std::string conditions =
        "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } edge_loads { where { x_min: 6 } "
        "force { x: 1e6 } } ";
    for (const char* quantity : {"STRESS_XX", "STRESS_YY", "STRESS_ZZ"})
      conditions += std::string("histories { quantity: ") + quantity + " at { x: 3.1 y: 0.4 } } ";
    FdmParticipant participant;
    wire::Setup setup = setup_of(conditions);
    setup.mutable_scene()->set_plane(plane_strain ? scene::PLANE_STRAIN : scene::PLANE_STRESS);
    wire::Model model;
    wire::Interface interface;
    participant.set_up(setup, model);
    participant.weigh({}, interface);
    wire::Predicted predicted;
    for (std::uint64_t n = 0; n <= 200; ++n) {
      wire::Advance advance;
      advance.set_step(n);
      advance.set_dt(2e-5);
      advance.set_want_histories(true);
      predicted.Clear();
      participant.advance(advance, predicted);
    }
    const auto& h = predicted.histories();
    EXPECT_GT(std::abs(h[0]), 1e4);
    EXPECT_NEAR(h[2], plane_strain ? 0.2 * (h[0] + h[1]) : 0, 1e-9 * std::abs(h[0]));
  }
}

// The acceleration is that of the step itself from the first on: a free body under its weight, with its half
// kick.
TEST(Histories, AccelerationIsCentredAtTheStep) {
  Conversation run(
      "body_loads { acceleration { y: -10 } time { table { time: 0 time: 1 value: 1 value: 2 } } } "
      "histories { name: 'a' quantity: ACCELERATION_Y at { x: 1.23 y: 0.7 } }");
  const double dt = 2e-5;
  for (std::uint64_t n = 0; n <= 100; ++n) {
    run.advance(n, dt);
    EXPECT_NEAR(run.predicted.histories(0), -10 * (1 + dt * static_cast<double>(n)), 1e-8);
  }
}

// At a point that another model corrects, the acceleration is that of the step before, correction and all:
// its sum is the velocity.
TEST(Histories, AccelerationOfATiedPointHoldsItsCorrection) {
  Conversation run(
      "histories { name: 'a' quantity: ACCELERATION_X at { x: 3 y: 0.5 } } "
      "histories { name: 'v' quantity: VELOCITY_X at { x: 3 y: 0.5 } }");
  wire::Couple couple;
  couple.add_points(3);
  couple.add_points(0.5);
  wire::Operator op;
  run.participant.couple(couple, op);
  const double dt = 2e-5;
  run.advance(0, dt);
  double velocity = 0;
  for (std::uint64_t n = 1; n <= 50; ++n) {
    run.advance(n, dt, {100 * std::sin(0.3 * static_cast<double>(n)), 0});
    velocity += (n == 1 ? dt / 2 : dt) * run.predicted.histories(0);
    EXPECT_NEAR(run.predicted.histories(1), velocity, 1e-15);
    EXPECT_NE(velocity, 0);
  }
}

}  // namespace
}  // namespace adit::fdm::test::histories_test
