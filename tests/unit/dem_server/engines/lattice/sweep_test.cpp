// Requirements on the order in which a step takes particles and bonds.
#include "dem_server/engines/lattice/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "dem_server/engines/lattice/critical_step.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::sweep_test {
namespace {

constexpr ContactBond kBrittle{{7.0, 3.0}, 0.02, 0.015};

Assembly shaken(const Model& packing) {
  Assembly a = test::assemble(packing, 2.0);
  test::fill_randomly(a.particles.vx, 0.01, 1);
  test::fill_randomly(a.particles.vy, 0.01, 2);
  test::fill_randomly(a.particles.spin, 0.01, 3);
  return a;
}

struct Outcome {
  Assembly assembly;
  BondResult last;
  std::vector<std::uint32_t> broken;  // in their order
};

// A hundred steps by the sweep; every 7th particle is kept, as if something else pulled on it too.
Outcome swept(const Model& packing, std::size_t threads, const ContactBond& law) {
  Outcome out{shaken(packing), {}, {}};
  Assembly& a = out.assembly;
  std::vector<Role> roles(a.particles.size(), Role::kSwept);
  for (std::size_t i = 0; i < roles.size(); i += 7) roles[i] = Role::kKept;
  protocol::Team team(threads);
  Sweep sweep(a.bonds.runs, roles, std::vector<bool>(roles.size(), true), threads);
  const double dt = 0.3 * critical_step(a, law.stiffness);
  for (std::uint64_t n = 0; n < 100; ++n) {
    const protocol::Step step{n, dt};
    out.last = {};
    sweep.run(team, law, step, a, out.last, out.broken);
    sweep.predict(team, step, a.particles);
  }
  return out;
}

// The same in three passes over everything.
Outcome passed(const Model& packing, const ContactBond& law) {
  Outcome out{shaken(packing), {}, {}};
  Assembly& a = out.assembly;
  const protocol::IndexRange all{0, static_cast<std::uint32_t>(a.particles.size())};
  const double dt = 0.3 * critical_step(a, law.stiffness);
  for (std::uint64_t n = 0; n < 100; ++n) {
    const protocol::Step step{n, dt};
    if (!step.from_rest()) move(dt, {&all, 1}, a.particles);
    out.last = test::compute_bond_forces(law, dt, a.particles, a.bonds, out.broken);
    kick(step, {&all, 1}, resultants_of(a.particles), a.particles);
  }
  return out;
}

// By the numbers of rows and of discs in a row; made by the test, since every start of the program makes the
// parameters. 9 968 particles make two blocks, 31 416 seven.
class Sweeps : public testing::TestWithParam<std::pair<int, int>> {
 protected:
  const Model packing = test::rows_of(GetParam().first, GetParam().second);
};
INSTANTIATE_TEST_SUITE_P(Sizes, Sweeps,
                         testing::Values(std::pair{6, 52}, std::pair{32, 312}, std::pair{100, 315}),
                         [](const auto& info) { return std::to_string(info.param.first) + "rows"; });

// One, two, three and eight threads give the same bits, breaking included.
TEST_P(Sweeps, ThreadsChangeNoBit) {
  const Outcome one = swept(packing, 1, kBrittle);
  EXPECT_GT(one.broken.size(), 20u);
  for (const std::size_t threads : {2u, 3u, 8u}) {
    const Outcome many = swept(packing, threads, kBrittle);
    EXPECT_EQ(many.broken, one.broken);
    EXPECT_EQ(many.last.max_normal_force, one.last.max_normal_force);
    EXPECT_EQ(many.last.strongest_bond, one.last.strongest_bond);
    EXPECT_EQ(many.last.released, one.last.released);
    for (auto member : {&Particles::ux, &Particles::uy, &Particles::vx, &Particles::vy, &Particles::spin})
      ASSERT_EQ(many.assembly.particles.*member, one.assembly.particles.*member);
    ASSERT_EQ(many.assembly.bonds.shear_force, one.assembly.bonds.shear_force);
  }
}

// The sweep is the plain step: what differs is the order of sums.
TEST_P(Sweeps, IsThePlainStep) {
  const ContactBond unbreakable{{7.0, 3.0}, kUnbreakable, kUnbreakable};
  const Outcome a = swept(packing, 2, unbreakable), b = passed(packing, unbreakable);
  EXPECT_NEAR(a.last.max_normal_force, b.last.max_normal_force, 1e-12 * b.last.max_normal_force);
  for (auto member : {&Particles::ux, &Particles::uy, &Particles::vx, &Particles::vy, &Particles::spin})
    for (std::size_t i = 0; i < packing.discs.size(); ++i)
      ASSERT_NEAR((a.assembly.particles.*member)[i], (b.assembly.particles.*member)[i], 1e-13) << i;
}

// Bonds that break in one step are told in the order of their numbers, wherever they were computed.
TEST_P(Sweeps, TellsBrokenBondsInOrder) {
  Assembly a = test::assemble(packing, 2.0);
  for (std::size_t i = 0; i < a.particles.size(); ++i) a.particles.ux[i] = 0.01 * a.particles.x[i];
  Sweep sweep(a.bonds.runs, std::vector(a.particles.size(), Role::kSwept),
              std::vector<bool>(a.particles.size(), true), 2);
  protocol::Team team(2);
  BondResult result;
  std::vector<std::uint32_t> broken;
  sweep.run(team, {{7.0, 3.0}, 1e-3, kUnbreakable}, {0, 0.1}, a, result, broken);
  EXPECT_EQ(broken.size(), a.bonds.size());
  EXPECT_TRUE(std::ranges::is_sorted(broken));
}

// What the sweep says of speed is the largest that moved something.
TEST_P(Sweeps, FindsTheLargestSpeed) {
  Assembly a = test::assemble(packing, 2.0);
  a.particles.vx[a.particles.size() / 2] = -3;
  a.particles.vy[a.particles.size() / 2] = 4;
  Sweep sweep(a.bonds.runs, std::vector(a.particles.size(), Role::kSwept),
              std::vector<bool>(a.particles.size(), true), 1);
  protocol::Team team;
  BondResult result;
  std::vector<std::uint32_t> broken;
  EXPECT_EQ(sweep.run(team, kBrittle, {1, 1e-6}, a, result, broken), 5);
}

}  // namespace
}  // namespace adit::dem::sweep_test
