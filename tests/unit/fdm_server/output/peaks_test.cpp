// Requirements on peaks over time: they are the largest of what histories say.
#include "fdm_server/output/peaks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "fdm_server/zones/critical_step.hpp"
#include "tests/unit/fdm_server/scenes.hpp"
#include "tests/unit/fdm_server/solver/standing_wave.hpp"

namespace adit::fdm::test::peaks_test {
namespace {

using testing::DoubleNear;

wire::Advance request(std::uint64_t step, double dt) {
  wire::Advance advance;
  advance.set_step(step);
  advance.set_dt(dt);
  advance.set_want_histories(true);
  return advance;
}

std::map<std::string, google::protobuf::RepeatedField<double>> fields(const wire::Piece& piece) {
  std::map<std::string, google::protobuf::RepeatedField<double>> fields;
  for (const auto* list : {&piece.point_fields(), &piece.cell_fields()})
    for (const auto& field : *list) fields[field.name()] = field.values();
  return fields;
}

// Over every step, the peaks at a grid point and in a zone are the largest of the dense histories there, to
// rounding.
TEST(Peaks, AreTheLargestOfDenseHistories) {
  std::string histories;
  for (const char* quantity :
       {"DISPLACEMENT_X", "DISPLACEMENT_Y", "VELOCITY_X", "VELOCITY_Y", "ACCELERATION_X", "ACCELERATION_Y"})
    histories += std::string("histories { name: 'a' quantity: ") + quantity + " at { x: 3 y: 0.5 } } ";
  for (const char* quantity :
       {"STRESS_XX", "STRESS_YY", "STRESS_XY", "STRAIN_XX", "STRAIN_YY", "SHEAR_STRAIN_XY"})
    histories += std::string("histories { name: 'a' quantity: ") + quantity +
                 " at { x: 0.75 y: 0.625 } } ";  // a centroid
  Conversation run(
      "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } edge_loads { where { x_min: 6 } force { x: 1e5 "
      "y: -1e6 } "
      "time { sine { frequency: 60 } } } " +
      histories);
  const double dt = 5e-5;
  std::array<double, 6> largest{0, 0, 0, 0, -HUGE_VAL, -HUGE_VAL};
  for (std::uint64_t n = 0; n <= 1000; ++n) {
    wire::Advance advance = request(n, dt);
    advance.set_want_peaks(true);
    wire::Predicted predicted;
    run.participant.advance(advance, predicted);
    const auto& h = predicted.histories();
    const double mean = (h[6] + h[7]) / 2, radius = std::hypot((h[6] - h[7]) / 2, h[8]);
    const std::array now{std::hypot(h[0], h[1]),          std::hypot(h[2], h[3]), std::hypot(h[4], h[5]),
                         std::hypot(h[9] - h[10], h[11]), mean + radius,          radius - mean};
    for (std::size_t i = 0; i < now.size(); ++i) largest[i] = std::max(largest[i], now[i]);
  }
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  auto found = fields(snapshot.pieces(0));
  const int point = 2 * 13 + 6, zone = 2 * 12 + 1;
  EXPECT_NEAR(found["peak_displacement_m"][point] / largest[0], 1, 1e-12);
  EXPECT_NEAR(found["peak_velocity_m_per_s"][point] / largest[1], 1, 1e-12);
  EXPECT_NEAR(found["peak_acceleration_m_per_s2"][point] / largest[2], 1, 1e-12);
  EXPECT_NEAR(found["peak_shear_strain"][zone] / largest[3], 1, 1e-12);
  EXPECT_NEAR(found["peak_largest_principal_stress_Pa"][zone] / largest[4], 1, 1e-12);
  EXPECT_NEAR(-found["peak_smallest_principal_stress_Pa"][zone] / largest[5], 1, 1e-12);
  EXPECT_GT(largest[0], 1e-4);
}

// The peaks of a standing wave are its amplitudes, within 1 % on 96 x 64 zones.
TEST(Peaks, AreTheAmplitudesOfAStandingWave) {
  const StandingWave wave;
  const Grid grid = make_grid(StandingWave::block(64));
  const double dt = 0.5 * critical_step(ZoneKind::kAssumedStrain, grid, wave.law, kDensity);
  const auto continuum = wave.start(ZoneKind::kAssumedStrain, grid, dt);
  Peaks peaks(grid, Ground{});
  protocol::Step step{0, dt};
  while (step.time() < 2 * std::numbers::pi / wave.w) {
    ++step.number;
    peaks.remember(*continuum);
    continuum->step(step);
    peaks.take(*continuum, step);
  }
  const double quarter = std::numbers::pi / 2 / wave.w;
  const auto largest = [](std::span<const double> values) { return *std::ranges::max_element(values); };
  double u = 0, v = 0, a = 0;
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    const auto full = wave.at(grid.x[i], grid.y[i], quarter), zero = wave.at(grid.x[i], grid.y[i], 0);
    u = std::max(u, std::hypot(full.ux, full.uy));
    v = std::max(v, std::hypot(zero.vx, zero.vy));
    a = std::max(a, std::hypot(full.ax, full.ay));
  }
  EXPECT_NEAR(largest(peaks.motion().displacement()) / u, 1, 0.002);
  EXPECT_NEAR(largest(peaks.motion().velocity()) / v, 1, 0.002);
  EXPECT_NEAR(largest(peaks.motion().acceleration()) / a, 1, 0.002);
  for (std::uint32_t z = 0; z < grid.zones.size(); z += 97) {
    const Corners c = corners(grid, z);
    const auto full = wave.at((c.x[0] + c.x[2]) / 2, (c.y[0] + c.y[2]) / 2, quarter);
    const double mean = (full.sxx + full.syy) / 2, radius = std::hypot((full.sxx - full.syy) / 2, full.sxy);
    const double size = wave.law.bulk * StandingWave::kAmplitude * wave.l * wave.l;
    EXPECT_NEAR(peaks.shear_strain()[z], std::hypot(full.exx - full.eyy, full.gxy),
                0.005 * size / wave.law.bulk);
    EXPECT_NEAR(peaks.largest_principal()[z], std::max(mean + radius, radius - mean), 0.005 * size);
    EXPECT_NEAR(peaks.smallest_principal()[z], -std::max(mean + radius, radius - mean), 0.005 * size);
  }
}

// A run that asks for no peaks has no such fields; what a coupled point is pushed by counts.
TEST(Peaks, AreOnlyThereWhereWantedAndAfterTheCorrection) {
  Conversation run("");
  wire::Couple couple;
  couple.add_points(3);
  couple.add_points(0.5);
  wire::Operator op;
  run.participant.couple(couple, op);
  const double dt = 2e-5;
  run.advance(0, dt);
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  EXPECT_FALSE(fields(snapshot.pieces(0)).contains("peak_displacement_m"));
  wire::Advance advance = request(1, dt);
  advance.set_want_peaks(true);
  wire::Predicted predicted;
  run.participant.advance(advance, predicted);
  wire::SnapshotRequest correction;
  correction.add_impulses(300);
  correction.add_impulses(-400);
  run.participant.snapshot(correction, snapshot);
  EXPECT_NEAR(fields(snapshot.pieces(0))["peak_acceleration_m_per_s2"][2 * 13 + 6],
              500 * op.inverse_masses(0) / dt, 1e-9);
}

}  // namespace
}  // namespace adit::fdm::test::peaks_test
