#include "dem_server/engines/lattice/assembly.hpp"

#include <gtest/gtest.h>

#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::assembly_test {
namespace {

constexpr double kCellMass = 3.0;

// Weights that fall linearly along x from 0 at x = 2 to 1 at x = 6.
double ramp(double x) {
  return std::clamp((x - 2) / 4, 0.0, 1.0);
}

struct Weighted {
  Model packing = test::rows_of(5, 10);
  std::vector<double> centres, midpoints;
  Assembly assembly;
  explicit Weighted(double floor) {
    for (const double x : packing.discs.x) centres.push_back(ramp(x));
    for (const Bond& link : packing.bonds)
      midpoints.push_back(ramp((packing.discs.x[link.first] + packing.discs.x[link.second]) / 2));
    assembly = test::assemble(packing, kCellMass, {centres, midpoints, floor});
  }
};

// Exactly the particles without weight vanish; the others keep the id that they had in the packing.
TEST(Assembly, ParticlesWithoutWeightVanishAndIdsStay) {
  const Weighted w(1e-3);
  const Particles& p = w.assembly.particles;
  std::size_t expected = 0;
  for (const double weight : w.centres) expected += weight > 0;
  EXPECT_LT(expected, w.packing.discs.x.size());
  ASSERT_EQ(p.size(), expected);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_GT(w.centres[p.id[i]], 0);
    EXPECT_EQ(p.x[i], w.packing.discs.x[p.id[i]]);
    EXPECT_EQ(p.y[i], w.packing.discs.y[p.id[i]]);
  }
}

// Bonds keep their midpoint's weight, not below the floor, and a particle's weight, mass and inertia
// follow the mean of its bonds' weights.
TEST(Assembly, ParticleWeightIsTheMeanOfItsBonds) {
  const double floor = 0.2;
  const Weighted w(floor);
  const Particles& p = w.assembly.particles;
  const Bonds& b = w.assembly.bonds;
  std::vector<double> sum(p.size(), 0), count(p.size(), 0);
  bool floored = false;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double middle = ramp((p.x[b.first[k]] + p.x[b.second[k]]) / 2);
    EXPECT_DOUBLE_EQ(b.weight[k], std::max(middle, floor));
    floored = floored || middle < floor;
    for (const std::uint32_t i : {b.first[k], b.second[k]}) sum[i] += b.weight[k], count[i] += 1;
  }
  EXPECT_TRUE(floored);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_DOUBLE_EQ(p.weight[i], sum[i] / count[i]);
    EXPECT_DOUBLE_EQ(p.mass[i], p.weight[i] * kCellMass);
    EXPECT_DOUBLE_EQ(p.inertia[i], p.mass[i] * 0.125);
    EXPECT_DOUBLE_EQ(p.inverse_mass[i] * p.mass[i], 1);
    EXPECT_DOUBLE_EQ(p.inverse_inertia[i] * p.inertia[i], 1);
  }
}

// A particle whose neighbours all vanish stays, with its centre's weight.
TEST(Assembly, LoneParticleKeepsItsCentreWeight) {
  const Model packing = test::rows_of(1, 3);
  const std::vector<double> centres{0.5, 0, 0.0001}, midpoints{0.4, 0.3};
  const Assembly a = test::assemble(packing, kCellMass, {centres, midpoints, 0.01});
  ASSERT_EQ(a.particles.size(), 2u);
  EXPECT_EQ(a.bonds.size(), 0u);
  EXPECT_EQ(a.particles.weight[0], 0.5);
  EXPECT_EQ(a.particles.weight[1], 0.01);
}

// Runs cover every bond once and describe its particles, however long the rows are.
TEST(Assembly, RunsCoverTheBonds) {
  const Assembly a = test::assemble(test::rows_of(3, 600), kCellMass);
  std::uint32_t next = 0;
  for (const adit::dem::Run& run : a.bonds.runs) {
    EXPECT_EQ(run.begin, next);
    EXPECT_LE(run.count, kLongestRun);
    for (std::uint32_t k = 0; k < run.count; ++k, ++next) {
      EXPECT_EQ(a.bonds.first[next], run.first + k);
      EXPECT_EQ(a.bonds.second[next], run.second + k);
    }
  }
  EXPECT_EQ(next, a.bonds.size());
  EXPECT_LT(a.bonds.runs.size(), 1.2 * static_cast<double>(a.bonds.size()) / kLongestRun);
}

// Runs are slow where one of their own bonds is weighted or broken, and nowhere else, wherever they begin and
// end.
TEST(Assembly, RunIsPlainUnlessABondOfItsOwnIsNot) {
  const std::uint32_t count = 300, weighted = 70, broken = 191;
  Bonds bonds;
  bonds.first.resize(count);
  bonds.second.resize(count);
  bonds.finish();
  bonds.set_weight(weighted, 0.5);
  bonds.break_bond(broken, BondState::kTensileCrack);
  for (std::uint32_t begin = 0; begin < count; ++begin)
    for (std::uint32_t end = begin + 1; end <= std::min(count, begin + kLongestRun); ++end) {
      const auto holds = [&](std::uint32_t bond) { return begin <= bond && bond < end; };
      ASSERT_EQ(bonds.plain({begin, end - begin, 0, 0, 0, 0}), !holds(weighted) && !holds(broken))
          << begin << " to " << end;
    }
}

}  // namespace
}  // namespace adit::dem::assembly_test
