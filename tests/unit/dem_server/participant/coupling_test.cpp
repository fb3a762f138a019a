// The overlap from the particles' side: weights, candidate points, operator, impulses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dem_server/model/calibration.hpp"
#include "protocol/errors.hpp"
#include "tests/unit/dem_server/cantilever_scene.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::coupling_test {
namespace {

using test::cantilever_scene;
using test::InProcessRun;

// The paper's overlap: particles have weight 0 at x = 4 and 1 at x = 6.
wire::Weights overlap_weights(const wire::Model& model) {
  wire::Weights weights;
  for (int k = 0; k < model.sample_points_size(); k += 2)
    weights.add_weights(std::clamp((model.sample_points(k) - 4) / 2, 0.0, 1.0));
  weights.set_floor(1e-3);
  weights.set_x_min(4);
  weights.set_x_max(6);
  weights.set_y_min(model.y_min());
  weights.set_y_max(model.y_max());
  return weights;
}

scene::Scene coupled_scene() {
  auto scene = cantilever_scene();
  scene.mutable_particles()->clear_loads();
  scene.mutable_particles()->mutable_histories(0)->mutable_at()->set_x(4);  // the particles' new end
  return scene;
}

struct Coupled : InProcessRun {
  wire::Operator op;
  Coupled() : InProcessRun(coupled_scene(), overlap_weights(InProcessRun(coupled_scene()).model)) {
    wire::Couple couple;
    *couple.mutable_points() = interface.points();
    participant.couple(couple, op);
  }
};

// The acceleration of a particle that the overlap corrects is that of the step before, correction and all:
// its sum is the velocity.
TEST(Coupling, AccelerationHoldsTheCorrection) {
  auto scene = coupled_scene();
  auto& histories = *scene.mutable_particles()->mutable_histories();
  histories[0].set_quantity(scene::ACCELERATION_X);
  *histories.Add() = histories[0];
  histories[1].set_quantity(scene::VELOCITY_X);
  InProcessRun run(scene, overlap_weights(InProcessRun(scene).model));
  wire::Couple couple;
  *couple.mutable_points() = run.interface.points();
  wire::Operator op;
  run.participant.couple(couple, op);
  run.advance();
  double velocity = 0;
  for (int n = 1; n <= 50; ++n) {
    run.advance(std::vector<double>(280, std::sin(0.3 * n)));
    velocity += (n == 1 ? run.dt / 2 : run.dt) * run.predicted.histories(0);
    EXPECT_NEAR(run.predicted.histories(1), velocity, 1e-14);
    EXPECT_NE(velocity, 0);
  }
}

// Ties that bear the weight of discs let them move steadily, and local damping takes nothing. Their
// weight is not what they lack of balance.
TEST(Coupling, LocalDampingTakesNothingFromSteadyMotion) {
  auto scene = test::placed_scene("x_m,y_m,radius_m\n0,0,0.5\n2,0,0.7\n");
  scene.mutable_particles()->mutable_damping()->set_local(0.2);
  scene.mutable_particles()->add_body_loads()->mutable_acceleration()->set_y(-10);
  wire::Weights weights;
  weights.mutable_weights()->Resize(2, 1.0);
  weights.set_x_min(-1);
  weights.set_x_max(3);
  weights.set_y_min(-1);
  weights.set_y_max(1);
  weights.set_floor(1);
  InProcessRun run(scene, weights);
  run.dt = 1e-4;
  wire::Couple couple;
  *couple.mutable_points() = run.interface.points();
  wire::Operator op;
  run.participant.couple(couple, op);
  ASSERT_EQ(op.inverse_masses_size(), 4);
  run.advance();
  double kinetic = 0, taken = 0;  // a few steps after the blow that set the discs in motion
  for (int n = 1; n <= 50; ++n) {
    std::vector<double> impulses;
    for (int k = 0; k < 4; ++k) {
      const double mass = 1 / op.inverse_masses(k), kick = n == 1 ? run.dt / 2 : run.dt;
      impulses.push_back(mass * ((k % 2 == 1 ? 10 * kick : 0) + (n == 1 ? 0.3 : 0)));
    }
    run.advance(impulses);
    if (n != 5) continue;
    kinetic = run.predicted.energies().kinetic();
    taken = run.shares().at("local_damping");
  }
  EXPECT_GT(kinetic, 0.01 * run.interface.mass());
  EXPECT_NEAR(run.predicted.energies().kinetic(), kinetic, 1e-9 * kinetic);
  EXPECT_NEAR(run.shares().at("local_damping"), taken, 1e-9 * kinetic);
}

// The coupled cantilever keeps 419 particles, of which 140 lie in the overlap.
TEST(Coupling, OverlapOfTheCantileverHasItsCounts) {
  const Coupled run;
  EXPECT_EQ(run.interface.particles(), 419u);
  EXPECT_EQ(run.interface.points_size(), 2 * 140);
}

// N is the identity, and the inverse masses are those of the weighted particles.
TEST(Coupling, OperatorIsTheIdentity) {
  const Coupled run;
  ASSERT_EQ(run.op.row_starts_size(), 141);
  ASSERT_EQ(run.op.columns_size(), 140);
  ASSERT_EQ(run.op.inverse_masses_size(), 280);
  const double mass = cell_mass(2500, test::kCantileverRadius);
  for (int k = 0; k < 140; ++k) {
    EXPECT_EQ(run.op.row_starts(k), static_cast<unsigned>(k));
    EXPECT_EQ(run.op.columns(k), static_cast<unsigned>(k));
    EXPECT_EQ(run.op.values(k), 1);
    EXPECT_EQ(run.op.inverse_masses(2 * k), run.op.inverse_masses(2 * k + 1));
    // Away from the ends of the ramp the mean of the bonds' weights is the centre's own weight.
    const double x = run.interface.points(2 * k), y = run.interface.points(2 * k + 1);
    if (x > 4.2 && x < 5.8 && y > 0.1 && y < 0.9) {
      EXPECT_NEAR(1 / (mass * run.op.inverse_masses(2 * k)), (x - 4) / 2, 1e-12);
    }
  }
}

// An impulse changes its particle's velocity by impulse / mass, and nothing else, before the next step moves.
TEST(Coupling, ImpulsesChangeThePredictedVelocities) {
  Coupled run;
  run.advance();
  EXPECT_THAT(run.predicted.velocities(), testing::Each(0));
  std::vector<double> impulses(280);
  impulses[2 * 70] = 30;
  impulses[2 * 70 + 1] = -20;
  const double x = run.interface.points(140), y = run.interface.points(141);
  wire::Snapshot snapshot;
  run.advance(impulses);
  run.participant.snapshot({}, snapshot);
  const auto& points = snapshot.pieces(0).points();
  const auto& displacement = snapshot.pieces(0).point_fields(0).values();
  for (int i = 0; 2 * i < points.size(); ++i) {
    const bool pushed = points[2 * i] == x && points[2 * i + 1] == y;
    EXPECT_EQ(displacement[3 * i], pushed ? run.dt * 30 * run.op.inverse_masses(140) : 0.0);
    EXPECT_EQ(displacement[3 * i + 1], pushed ? run.dt * -20 * run.op.inverse_masses(141) : 0.0);
  }
}

// Impulses that come with a snapshot's request act as those of the next step would: the snapshot's momentum
// is theirs, and the run goes on to the same bits.
TEST(Coupling, SnapshotBringsTheCorrection) {
  std::vector<double> impulses(280);
  double momentum = 0;
  for (std::size_t k = 0; k < impulses.size(); ++k) momentum += impulses[k] = static_cast<double>(k) - 100;
  Coupled seen, unseen;
  seen.advance();
  unseen.advance();
  wire::SnapshotRequest request;
  request.mutable_impulses()->Assign(impulses.begin(), impulses.end());
  wire::Snapshot snapshot;
  seen.participant.snapshot(request, snapshot);
  const auto& velocity = snapshot.pieces(0).point_fields(1);
  const auto& weight = snapshot.pieces(0).point_fields(4);
  ASSERT_EQ(velocity.name(), "velocity_m_per_s");
  ASSERT_EQ(weight.name(), "weight");
  double found = 0;
  for (int i = 0; i < weight.values_size(); ++i)
    found += cell_mass(2500, test::kCantileverRadius) * weight.values(i) *
             (velocity.values(3 * i) + velocity.values(3 * i + 1));
  EXPECT_NEAR(found, momentum, 1e-9 * momentum);
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(seen.advance().SerializeAsString(),
              unseen.advance(n == 0 ? impulses : std::vector<double>{}).SerializeAsString());
  }
}

// Impulses on a particle whose motion is prescribed are ignored, and its inverse mass is 0.
TEST(Coupling, PrescribedParticlesIgnoreImpulses) {
  auto scene = coupled_scene();
  auto& motion = *scene.mutable_particles()->add_motions();
  motion.mutable_where()->set_x_max(5);
  motion.mutable_velocity()->set_x(0.25);
  InProcessRun run(scene, overlap_weights(InProcessRun(scene).model));
  wire::Couple couple;
  couple.add_points(run.interface.points(0));
  couple.add_points(run.interface.points(1));
  wire::Operator op;
  run.participant.couple(couple, op);
  EXPECT_EQ(op.inverse_masses(0), 0);
  EXPECT_GT(op.inverse_masses(1), 0);
  run.advance();
  run.advance({1000.0, 0.0});
  EXPECT_EQ(run.predicted.velocities(0), 0.25);
}

// The reaction of a prescribed motion takes up the impulses on its particles: they change no motion, and the
// work that each does, with the mean of the velocities before and after, the reaction takes back.
TEST(Coupling, ReactionsTakeUpTheImpulsesOnPrescribedParticles) {
  auto scene = coupled_scene();
  auto& motion = *scene.mutable_particles()->add_motions();
  motion.mutable_where()->set_x_max(5);
  motion.mutable_velocity()->set_x(0.25);
  motion.mutable_time()->mutable_sine()->set_frequency(300);
  motion.mutable_time()->mutable_sine()->set_phase(1);
  const auto weights = overlap_weights(InProcessRun(scene).model);
  InProcessRun pushed(scene, weights), alone(scene, weights);
  for (auto* run : {&pushed, &alone}) {
    wire::Couple couple;
    couple.add_points(run->interface.points(0));
    couple.add_points(run->interface.points(1));
    wire::Operator op;
    run->participant.couple(couple, op);
  }
  const auto impulse = [](int n) { return 50 + 1000 * std::sin(0.1 * n); };
  double work = 0, before = 0, largest = 0;
  for (int n = 0; n <= 300; ++n) {
    pushed.advance(n == 0 ? std::vector<double>{} : std::vector<double>{impulse(n - 1), 0.0});
    alone.advance();
    const double after = pushed.predicted.velocities(0);
    ASSERT_EQ(after, alone.predicted.velocities(0));
    ASSERT_EQ(pushed.predicted.energies().strain(), alone.predicted.energies().strain());
    largest = std::max(largest, std::abs(work) + alone.predicted.energies().strain());
    EXPECT_NEAR(pushed.predicted.energies().external_work(),
                alone.predicted.energies().external_work() - work, 1e-12 * largest)
        << "step " << n;
    if (n == 0) before = -after;  // from rest
    work += 0.5 * (before + after) * impulse(n);
    before = after;
  }
  EXPECT_GT(std::abs(work), 1e3);
}

// A coupling point that is no centre moves with the particles around it; impulses on it are shared in the
// same way, so that none of their momentum is lost. Beside a centre by rounding it still is that particle.
TEST(Coupling, PointsBetweenParticlesInterpolate) {
  InProcessRun run(coupled_scene(), overlap_weights(InProcessRun(coupled_scene()).model));
  wire::Couple couple;
  for (const double value :
       {5.01, 0.43, 5.77, 0.21, std::nextafter(run.interface.points(40), 10), run.interface.points(41)})
    couple.add_points(value);
  wire::Operator op;
  run.participant.couple(couple, op);
  EXPECT_THAT(op.row_starts(), testing::ElementsAre(0, 3, 6, 7));
  EXPECT_EQ(op.values(6), 1);
  run.advance();
  wire::SnapshotRequest request;
  for (const double impulse : {20.0, -5.0, 8.0, 3.0, 1.0, -1.0}) request.add_impulses(impulse);
  wire::Snapshot snapshot;
  run.participant.snapshot(request, snapshot);
  const auto& velocity = snapshot.pieces(0).point_fields(1);
  const auto& weight = snapshot.pieces(0).point_fields(4);
  double x = 0, y = 0;
  for (int i = 0; i < weight.values_size(); ++i) {
    const double mass = cell_mass(2500, test::kCantileverRadius) * weight.values(i);
    x += mass * velocity.values(3 * i);
    y += mass * velocity.values(3 * i + 1);
  }
  EXPECT_NEAR(x, 29, 1e-12);
  EXPECT_NEAR(y, -3, 1e-12);
}

// Where the particles do not reach, the error names the place and what to do.
TEST(Coupling, RefusesPointsOutsideTheParticles) {
  InProcessRun run(coupled_scene(), overlap_weights(InProcessRun(coupled_scene()).model));
  const auto tie = [&](const std::vector<double>& points) {
    wire::Couple couple;
    couple.mutable_points()->Assign(points.begin(), points.end());
    wire::Operator op;
    run.participant.couple(couple, op);
  };
  EXPECT_THROW(tie({1.0}), std::logic_error);
  EXPECT_THROW(tie({std::nan(""), 0.5}), std::logic_error);
  try {
    tie({5, 0.5, 3.5, 0.5});
    FAIL() << "accepted";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "interface.overlap");
    EXPECT_STREQ(
        error.what(),
        "holds the coupling point (3.5, 0.5) m, which lies more than a particle's diameter outside the "
        "bonded particles; let the packing cover the overlap");
  }
}

// Weights that do not fit the sample points, or lie outside [0, 1], are refused.
TEST(Coupling, RefusesWeightsThatDoNotFit) {
  const auto good = overlap_weights(InProcessRun(coupled_scene()).model);
  auto few = good, above = good, nan = good, floor = good;
  few.mutable_weights()->RemoveLast();
  above.set_weights(5, 1.5);
  nan.set_weights(5, std::nan(""));
  floor.set_floor(0);
  for (const auto& weights : {few, above, nan, floor})
    EXPECT_THROW(InProcessRun(coupled_scene(), weights), std::logic_error);
}

}  // namespace
}  // namespace adit::dem::coupling_test
