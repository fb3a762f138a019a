// Requirement: a run stays stable when a particle region breaks away completely. The grid moves on alone, the
// free particles fly on, momentum is kept, and breaking creates no energy. The same holds if every bond
// breaks, also inside the overlap.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/support/momentum.hpp"
#include "tests/verification/bridging/bars.hpp"

namespace adit::break_away_test {
namespace {

struct BreakAway : testing::TestWithParam<std::tuple<scene::Solve, unsigned>> {
  // A push at the left end arrives as pressure and comes back from the right end as tension, of up to 6e5 N a
  // bond.
  static constexpr test::Push kPush{3e6, 0, 0.004};

  coupler::Model model(double strength) const {
    const auto [solve, substeps] = GetParam();
    const test::Bar bar{
        "", {{test::Stretch::kGrid, 0, 5, 0.5}, {test::Stretch::kLattice, 3, 8, 0.1}}, {{0, 1, 3, 5}}};
    scene::Scene scene = test::scene_of(bar, solve);
    scene.mutable_time()->set_substeps(substeps);
    scene.mutable_time()->set_duration(0.06);
    auto& bonds = *scene.mutable_regions(1)->mutable_particles()->mutable_bonds();
    bonds.set_tensile_strength(strength);
    bonds.set_shear_strength(strength);
    test::push_left_end(kPush, bar, scene);
    return test::local_model(scene);
  }

  // Runs to the end; returns the share of bonds that broke. A bond that breaks within a step costs an energy
  // of first order in the step. With substeps half a window of the grid's impulse is still to come at the
  // end.
  double expect_stable(coupler::Model& model) const {
    const bool substeps = model.substeps > 1;
    coupler::Stepper stepper(model);
    double impulse = 0;  // of a load of 1 N, as the scheme sums it
    for (std::uint64_t n = 0; n <= model.steps; ++n) {
      stepper.step(n, {.energies = true});
      impulse += (n == 0 ? 0.5 : 1.0) * model.dt * kPush.factor(static_cast<double>(n) * model.dt);
      EXPECT_LE(stepper.ledger().drift(), 1e-3) << "step " << n;
    }
    const auto momentum = test::momentum(stepper.snapshots(), test::kDensity);
    EXPECT_NEAR(momentum[0], kPush.x * impulse, (substeps ? 1e-2 : 1e-10) * kPush.x * impulse);
    return static_cast<double>(model.participants[1].cracks.size()) /
           static_cast<double>(model.participants[1].counts.bonds());
  }
};

TEST_P(BreakAway, APartFliesOff) {
  coupler::Model model = this->model(1e5);
  EXPECT_GT(expect_stable(model), 0.1);
}

TEST_P(BreakAway, EveryParticleFliesOff) {
  coupler::Model model = this->model(1e3);
  EXPECT_GT(expect_stable(model), 0.99);
}

INSTANTIATE_TEST_SUITE_P(AllSolves, BreakAway,
                         testing::Combine(testing::Values(scene::CONSISTENT, scene::LUMPED, scene::SPLIT),
                                          testing::Values(1U, 2U, 4U)),
                         [](const auto& info) {
                           return scene::Solve_Name(std::get<0>(info.param)) + "_" +
                                  std::to_string(std::get<1>(info.param));
                         });

}  // namespace
}  // namespace adit::break_away_test
