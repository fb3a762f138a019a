// Requirement: a lattice is computed the same by the engine of lattices and by that of any discs, alone and
// coupled to a continuum, elastic and cracking.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coupler/stepping/stepper.hpp"
#include "protocol/scene/reader.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::engines_test {
namespace {

struct Outcome {
  std::vector<double> tip, force;                    // of every step [m], [N]
  std::vector<std::array<std::uint64_t, 4>> cracks;  // step, mode, parents
  std::vector<std::array<double, 4>> shapes;         // place, length, orientation
  double drift = 0;
  double unbooked =
      0;  // of it what the discs do not book as their time step's share, over the largest stored energy
};

scene::Scene cantilever(const std::string& name, scene::Particles::Engine engine) {
  auto scene = protocol::read_scene(std::string(ADIT_CASES) + "/cantilever/" + name + ".yaml").scene;
  scene.mutable_particles()->set_engine(engine);
  return scene;
}

Outcome compute(const scene::Scene& scene) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  Outcome outcome;
  double unbooked = 0, stored = 0;
  for (std::uint64_t n = 0; n <= model.steps; ++n) {
    stepper.step(n, {.energies = n % 10 == 0, .histories = true});
    for (const coupler::Participant& participant : model.participants) {
      const wire::Predicted& predicted = participant.prediction();
      if (predicted.histories_size() == 1) outcome.tip.push_back(predicted.histories(0));
      if (participant.member.role != coupler::Role::kParticles) continue;
      if (!predicted.energies().shares().empty()) {
        const wire::EnergyShare& time_step = *predicted.energies().shares().rbegin();
        EXPECT_EQ(time_step.name(), "time_step");
        unbooked = std::max(unbooked, std::abs(stepper.ledger().unexplained() + time_step.value()));
        stored = std::max(stored, stepper.ledger().stored());
      }
      outcome.force.push_back(predicted.strongest(0).force());
      for (const wire::Crack& crack : predicted.cracks()) {
        outcome.cracks.push_back(
            {crack.step(), static_cast<std::uint64_t>(crack.mode()), crack.parent_a(), crack.parent_b()});
        outcome.shapes.push_back({crack.x(), crack.y(), crack.length(), crack.orientation()});
      }
    }
  }
  outcome.drift = stepper.ledger().max_drift();
  outcome.unbooked = stored > 0 ? unbooked / stored : 0;
  return outcome;
}

void expect_near(const std::vector<double>& one, const std::vector<double>& other, double share) {
  ASSERT_EQ(one.size(), other.size());
  double most = 0, apart = 0;
  for (std::size_t n = 0; n < one.size(); ++n) {
    most = std::max(most, std::abs(one[n]));
    apart = std::max(apart, std::abs(one[n] - other[n]));
  }
  EXPECT_LT(apart, share * most);
}

class Engines : public testing::TestWithParam<const char*> {};

TEST_P(Engines, AgreeOnALattice) {
  const Outcome lattice = compute(cantilever(GetParam(), scene::Particles::LATTICE)),
                discs = compute(cantilever(GetParam(), scene::Particles::GENERAL));
  // Slip by the middle of the step (laws/pair_kinematics.hpp) is all that differs.
  expect_near(lattice.tip, discs.tip, 1e-5);
  ASSERT_EQ(lattice.cracks.size(), discs.cracks.size());
  for (std::size_t k = 0; k < lattice.cracks.size(); ++k) {
    EXPECT_EQ(std::vector(lattice.cracks[k].begin() + 1, lattice.cracks[k].end()),
              std::vector(discs.cracks[k].begin() + 1, discs.cracks[k].end()));
    EXPECT_NEAR(static_cast<double>(lattice.cracks[k][0]), static_cast<double>(discs.cracks[k][0]), 2);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(lattice.shapes[k][c], discs.shapes[k][c], 1e-9);
  }
  EXPECT_LT(discs.drift, lattice.drift);
  EXPECT_LT(discs.unbooked, 1e-10);
}
INSTANTIATE_TEST_SUITE_P(Cantilever, Engines, testing::Values("full_dem", "coupled"));

// Parallel bonds that crack beside contacts with friction, coupled to a continuum: the energies of both close
// but for what the time step takes, which the discs' own books say.
TEST(CoupledDiscs, KeepEnergyAsParallelBondsBreak) {
  scene::Scene scene = cantilever("coupled", scene::Particles::AUTOMATIC);
  const double radius = scene.particles().packing().radius();
  auto& bonds = *scene.mutable_particles()->mutable_bonds();
  bonds.Clear();
  auto& parallel = *bonds.mutable_parallel();
  parallel.set_normal_stiffness(0.5 * 1.8e10 / (2 * radius));
  parallel.set_shear_stiffness(0.5 * 6e9 / (2 * radius));
  parallel.set_tensile_strength(3e7);
  parallel.set_cohesion(6e7);
  auto& contacts = *scene.mutable_particles()->mutable_contacts();
  contacts.set_normal_stiffness(9e9);
  contacts.set_shear_stiffness(3e9);
  contacts.set_friction(0.5);
  const Outcome outcome = compute(scene);
  EXPECT_GT(outcome.cracks.size(), 0u);
  EXPECT_LT(outcome.drift, 1e-3);
  EXPECT_LT(outcome.unbooked, 1e-10);
}

}  // namespace
}  // namespace adit::engines_test
