// Requirements on computing what the interface needs first and the interior afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/errors.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::deferral_test {
namespace {

using test::cantilever_scene;

// Either part holds whole runs, and together every bond once; exactly the bonds with a chosen particle are in
// the first.
TEST(SplitRuns, PartitionTheBonds) {
  const Assembly a = test::assemble(test::rows_of(9, 300), 1.0);
  std::vector<bool> chosen(a.particles.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = (i / 13) % 5 == 2;
  const SplitRuns parts = split(a.bonds.runs, chosen);
  std::vector<int> seen(a.bonds.size(), 0);
  for (const bool touching : {true, false})
    for (const auto& run : touching ? parts.touching : parts.others)
      for (std::uint32_t k = 0; k < run.count; ++k) {
        const std::uint32_t bond = run.begin + k;
        ++seen[bond];
        ASSERT_EQ(run.first + k, a.bonds.first[bond]);
        ASSERT_EQ(run.second + k, a.bonds.second[bond]);
        EXPECT_EQ(chosen[run.first + k] || chosen[run.second + k], touching);
      }
  EXPECT_THAT(seen, testing::Each(1));
}

// The cantilever's part in [4, 10] m as the coupler would drive it, its other side a spring and a dashpot at
// places between and on centres of [4, 6] m. A load, gravity, a fixed and a shaken part lie on both sides of
// the division.
struct CoupledRun : adit::test::CoupledRun<DemParticipant> {
  explicit CoupledRun(double strength, double speed_of_far_end = 0, bool coupled = true) {
    wire::Setup setup;
    *setup.mutable_scene() = cantilever_scene();
    auto& particles = *setup.mutable_scene()->mutable_particles();
    particles.mutable_bonds()->set_tensile_strength(strength);
    particles.mutable_loads(0)->mutable_where()->set_x_max(7);
    particles.add_body_loads()->mutable_acceleration()->set_y(-9.81);
    particles.mutable_motions(0)->mutable_velocity()->set_x(speed_of_far_end);
    auto& shaken = *particles.add_motions();
    shaken.mutable_where()->set_x_min(5.5);
    shaken.mutable_where()->set_x_max(6.5);
    shaken.mutable_where()->set_y_max(0.06);
    shaken.mutable_velocity()->set_x(0.1);
    shaken.mutable_time()->mutable_sine()->set_frequency(200);
    auto& speed = *particles.add_histories();
    speed.set_name("speed");
    speed.set_quantity(scene::VELOCITY_Y);
    for (int i = 0; i < 2; ++i) particles.mutable_histories(i)->mutable_at()->set_x(5 + 2 * i);
    speed.mutable_at()->set_y(0);
    set_up(setup);
    dt = 0.5 * model.critical_dt();

    wire::Weights weights;
    weights.set_x_min(5);
    weights.set_x_max(5.5);
    weights.set_y_max(model.y_max());
    weigh([](double x) { return std::clamp((x - 4) / 2, 0.0, 1.0); }, weights);
    if (!coupled) return;
    wire::Couple own;
    *own.mutable_points() = interface.points();
    couple(4.2, 1.8, 60, own);
  }

  double impulse(std::size_t i, double velocity) override {
    displacements_.resize(std::max(displacements_.size(), i + 1));
    displacements_[i] += dt * velocity;
    return -0.1 * velocity - 5e7 * dt * displacements_[i];
  }

 private:
  std::vector<double> displacements_;
};

// What a run says of its steps, in the order in which it is told.
struct Told {
  std::vector<std::string> cracks, strongest;
  void add(const wire::Predicted& predicted) {
    for (const auto& crack : predicted.cracks()) cracks.push_back(crack.SerializeAsString());
    for (const auto& force : predicted.strongest()) strongest.push_back(force.SerializeAsString());
  }
};

// The answers do not depend on when the interior is computed: neither velocities nor energies, histories,
// cracks and fields differ by a bit between a run that wants energies at every step and one that wants them
// rarely.
TEST(Deferral, KeepsEveryBit) {
  CoupledRun always(3e6), rarely(3e6);
  Told of_always, of_rarely;
  for (std::uint64_t n = 0; n <= 1500; ++n) {
    const bool wanted = n % 50 == 7 || n == 1500;
    always.advance(true);
    rarely.advance(wanted);
    rarely.participant.complete();
    of_always.add(always.predicted);
    of_rarely.add(rarely.predicted);
    for (auto* predicted : {&always.predicted, &rarely.predicted}) {
      predicted->clear_cracks();
      predicted->clear_strongest();
      if (!wanted) {
        predicted->clear_energies();
        predicted->clear_histories();
      }
    }
    ASSERT_EQ(always.predicted.SerializeAsString(), rarely.predicted.SerializeAsString()) << "step " << n;
  }
  EXPECT_GT(of_always.cracks.size(), 3u) << "the test must see bonds break";
  EXPECT_EQ(of_always.strongest.size(), 1501u) << "one a step";
  EXPECT_EQ(of_always.cracks, of_rarely.cracks);
  EXPECT_EQ(of_always.strongest, of_rarely.strongest);
  wire::SnapshotRequest request;
  request.mutable_impulses()->Assign(always.impulses.begin(), always.impulses.end());
  wire::Snapshot a, b;
  always.participant.snapshot(request, a);
  rarely.participant.snapshot(request, b);
  EXPECT_EQ(a.SerializeAsString(), b.SerializeAsString());
}

// Dividing the work changes nothing but the order of some sums: without impulses a run with coupling points
// is the run without.
TEST(Deferral, DividesNoPhysics) {
  CoupledRun divided(kUnbreakable), whole(kUnbreakable, 0, false);
  double largest = 0;
  for (int n = 0; n <= 1000; ++n) {
    for (auto* run : {&divided, &whole}) {
      run->impulses.clear();
      run->advance(n % 10 == 0);
      run->participant.complete();
    }
    if (n % 10 != 0) continue;
    for (int i = 0; i < 2; ++i) {
      largest = std::max(largest, std::abs(whole.predicted.histories(i)));
      ASSERT_NEAR(divided.predicted.histories(i), whole.predicted.histories(i), 1e-11 * largest) << n;
    }
    const auto &a = divided.predicted.energies(), &b = whole.predicted.energies();
    ASSERT_NEAR(a.strain(), b.strain(), 1e-9 * b.strain()) << n;
    ASSERT_NEAR(a.external_work(), b.external_work(), 1e-9 * std::abs(b.external_work())) << n;
  }
  EXPECT_GT(whole.predicted.energies().strain(), 1);
}

// A step is told of when it was computed to its end: in the next answer where its interior came later, at
// once where nothing was left.
TEST(Deferral, ReportsWholeSteps) {
  CoupledRun run(3e6);
  const auto steps = [&](bool wanted) {
    run.advance(wanted);
    run.participant.complete();
    std::vector<std::uint64_t> told;
    for (const auto& force : run.predicted.strongest()) told.push_back(force.step());
    return told;
  };
  EXPECT_THAT(steps(false), testing::ElementsAre());
  EXPECT_THAT(steps(false), testing::ElementsAre(0));
  EXPECT_THAT(steps(true), testing::ElementsAre(1, 2));
  EXPECT_THAT(steps(true), testing::ElementsAre(3));
  EXPECT_THAT(steps(false), testing::ElementsAre());
}

// A force of the interior that is not finite ends the run from complete(), with step and place.
TEST(Deferral, InstabilityOfTheInteriorIsFound) {
  CoupledRun run(kUnbreakable, 1e300);
  run.advance(false);
  run.participant.complete();
  ASSERT_NO_THROW(run.advance(false));
  try {
    run.participant.complete();
    FAIL() << "ran on";
  } catch (const protocol::Unstable& error) {
    EXPECT_THAT(error.what(),
                testing::MatchesRegex("step 1: the normal force of the bond at \\(9.*m is .*(nan|inf) N.*"));
  }
}

}  // namespace
}  // namespace adit::dem::deferral_test
