// Requirements on computing what the interface needs first and the interior afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/errors.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::deferral_test {
namespace {

using testing::HasSubstr;

constexpr double kDt = 2e-5;

// Either part holds whole runs of consecutive zones, and together every zone once; exactly the zones with a
// chosen point are in the first.
TEST(SplitRuns, PartitionTheZones) {
  Grid grid = make_grid({0, 10, 0, 1, 200, 5});
  std::vector<double> weights = ones(grid);
  for (std::size_t z = 0; z < weights.size(); z += 37) weights[z] = 0;
  compact(grid, weights);
  std::vector<bool> chosen(grid.x.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = (i / 11) % 4 == 1;
  const ZoneSet zones(kKinds[0], grid, plane_stress(kYoung, kPoisson), weights);
  const SplitRuns parts = split(zones.runs(), chosen);
  std::vector<int> seen(grid.zones.size(), 0);
  for (const bool touching : {true, false})
    for (const ZoneRun& run : touching ? parts.touching : parts.others)
      for (std::uint32_t k = 0; k < run.count; ++k) {
        const auto& zone = grid.zones[run.first + k];
        ++seen[run.first + k];
        for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(run.points[c] + static_cast<std::int32_t>(k), zone[c]);
        EXPECT_EQ(std::ranges::any_of(zone, [&](auto point) { return chosen[point]; }), touching);
      }
  EXPECT_THAT(seen, testing::Each(1));
}

// The first half of a step moves the interface and nothing else, the second one the rest.
TEST(Deferral, TheHalvesOfAStepShareThePoints) {
  const Grid grid = make_grid({0, 6, 0, 1, 12, 4});
  const auto masses = lumped_masses(grid, ones(grid), kDensity);
  Load everywhere{{}, {}, {}, [](double) { return 1.0; }};
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) {
    everywhere.points.push_back(i);
    everywhere.fx.push_back(masses[i]);
    everywhere.fy.push_back(-masses[i]);
  }
  Continuum continuum(ZoneSet(kKinds[0], grid, plane_stress(kYoung, kPoisson), ones(grid)), masses,
                      {everywhere}, {});
  const std::set<std::uint32_t> interface { 14, 15, 27, 40, 64 };
  continuum.set_interface(std::vector<std::uint32_t>(interface.begin(), interface.end()));
  continuum.step_interface({0, kDt});
  for (std::uint32_t i = 0; i < grid.x.size(); ++i)
    EXPECT_EQ(continuum.vx()[i] != 0, interface.contains(i)) << i;
  continuum.step_interior({0, kDt});
  for (std::uint32_t i = 0; i < grid.x.size(); ++i) EXPECT_NEAR(continuum.vx()[i], kDt / 2, 1e-18) << i;
}

// A coupled run as the coupler would drive it, its other side a dashpot at every coupling point. The overlap
// ends in [3, 6] m; a load, gravity and two motions act on both parts. Energies and histories are wanted at
// every `stride`-th step.
struct CoupledRun : adit::test::CoupledRun<FdmParticipant> {
  explicit CoupledRun(const std::string& zone = "", bool coupled = true) {
    set_up(setup_of(zone + " edge_loads { where { x_min: 1 x_max: 5 y_min: 1 } force { x: 2e6 y: -3e6 } "
                           "  time { sine { frequency: 400 } } } "
                           "body_loads { acceleration { y: -9.81 } } "
                           "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } "
                           "motions { where { y_max: 0 x_min: 2 } velocity { y: 0.2 } "
                           "  time { sine { frequency: 300 } } } "
                           "histories { name: 'u' quantity: DISPLACEMENT_X at { x: 1 y: 1 } } "
                           "histories { name: 'v' quantity: VELOCITY_Y at { x: 4 y: 1 } }"));
    dt = kDt;
    weigh([](double x) { return std::clamp((6.2 - x) / 3.2, 0.0, 1.0); });
    if (coupled) couple(3, 3, 40);
  }

  double impulse(std::size_t, double velocity) override { return -0.05 * velocity; }
};

// The answers do not depend on when the interior is computed: neither velocities nor energies, histories and
// fields differ by a bit between a run that wants energies at every step and one that wants them rarely.
TEST(Deferral, KeepsEveryBit) {
  for (const std::string zone : {"", "zone: MIXED_DISCRETIZATION"}) {
    CoupledRun always(zone), rarely(zone);
    for (std::uint64_t n = 0; n <= 600; ++n) {
      const bool wanted = n % 50 == 7;
      always.advance(true);
      rarely.advance(wanted);
      rarely.participant.complete();
      if (!wanted) {
        always.predicted.clear_energies();
        always.predicted.clear_histories();
      }
      ASSERT_EQ(always.predicted.SerializeAsString(), rarely.predicted.SerializeAsString()) << "step " << n;
    }
    EXPECT_GT(std::abs(rarely.predicted.velocities(0)), 1e-3);
    wire::SnapshotRequest request;
    request.mutable_impulses()->Assign(always.impulses.begin(), always.impulses.end());
    wire::Snapshot a, b;
    always.participant.snapshot(request, a);
    rarely.participant.snapshot(request, b);
    EXPECT_EQ(a.SerializeAsString(), b.SerializeAsString());
  }
}

// Dividing the work changes nothing but the order of some sums: without impulses a run with coupling points
// is the run without.
TEST(Deferral, DividesNoPhysics) {
  CoupledRun divided, whole("", false);
  for (int n = 0; n <= 1000; ++n) {
    for (auto* run : {&divided, &whole}) {
      run->impulses.clear();
      run->advance(n % 10 == 0);
      run->participant.complete();
    }
    if (n % 10 != 0) continue;
    const auto &a = divided.predicted.energies(), &b = whole.predicted.energies();
    ASSERT_NEAR(a.kinetic(), b.kinetic(), 1e-11 * std::abs(b.kinetic())) << n;
    ASSERT_NEAR(a.strain(), b.strain(), 1e-11 * b.strain()) << n;
    ASSERT_NEAR(a.external_work(), b.external_work(), 1e-11 * std::abs(b.external_work())) << n;
  }
  wire::Snapshot a, b;
  divided.participant.snapshot({}, a);
  whole.participant.snapshot({}, b);
  const auto &of_divided = a.pieces(0).point_fields(0).values(),
             &of_whole = b.pieces(0).point_fields(0).values();
  double largest = 0;
  for (const double value : of_whole) largest = std::max(largest, std::abs(value));
  for (int i = 0; i < of_whole.size(); ++i) EXPECT_NEAR(of_divided[i], of_whole[i], 1e-11 * largest);
}

// A velocity of the interior that is not finite ends the run from complete(), with step and place.
TEST(Deferral, InstabilityOfTheInteriorIsFound) {
  FdmParticipant participant;
  wire::Model model;
  participant.set_up(
      setup_of("point_loads { where { x_max: 0 } force { x: 1e308 } "
               "  time { table { time: 0 time: 1.9e-3 time: 2e-3 value: 0 value: 0 value: 1e300 } } }"),
      model);
  wire::Interface interface;
  participant.weigh({}, interface);
  wire::Couple couple;
  couple.add_points(6);
  couple.add_points(0.5);
  wire::Operator op;
  participant.couple(couple, op);
  const auto run_on = [&] {
    for (std::uint64_t n = 0; n <= 100; ++n) {
      wire::Advance request;
      request.set_step(n);
      request.set_dt(kDt);
      wire::Predicted predicted;
      EXPECT_NO_THROW(participant.advance(request, predicted)) << "step " << n;
      participant.complete();
    }
  };
  try {
    run_on();
    FAIL() << "no error";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 100: the velocity of the grid point at (0, 0) m"));
  }
}

}  // namespace
}  // namespace adit::fdm::test::deferral_test
