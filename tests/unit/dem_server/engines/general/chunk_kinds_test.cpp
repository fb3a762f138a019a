// Chunks of pairs leave out what their pairs do not need; that changes no bit of what they compute.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>
#include <string>

#include "tests/unit/dem_server/discs_models.hpp"

namespace adit::dem::chunk_kinds_test {
namespace {

using Kind = Pairs::Kind;

struct Variant {
  std::string name;
  bool parallel = false, dashpots = false;
  bool stressed = false, weighted = false, two_laws = false, two_widths = false, mixed = false;
  Kind expected;
};
std::ostream& operator<<(std::ostream& out, const Variant& variant) {
  return out << variant.name;
}

// 12 rows of 24 discs of one size in a hexagonal lattice, each bonded to its neighbours.
Model lattice(const Variant& variant) {
  constexpr double kRadius = 0.1;
  std::vector<std::array<double, 3>> places;
  for (int row = 0; row < 12; ++row)
    for (int k = 0; k < 24; ++k)
      places.push_back({(2 * k + row % 2) * kRadius, row * std::sqrt(3.0) * kRadius, kRadius});
  const double beta = variant.dashpots ? 0.2 : 0;
  Model model = test::loose_discs(places, {2e8, 1e8, 0.4, beta, beta});
  model.contact_bonds = {{{2e8, 1e8}, 2e4, 3e4}, {{1e8, 4e7}, 1e4, 2e4}};
  for (const double radius : {0.1, 0.07}) model.parallel_bonds.push_back({2e9, 1e9, radius, 2e5, 2e5, 0.5});
  test::join(model, variant.parallel ? Bond::Law::kParallelBond : Bond::Law::kContactBond);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    Bond& bond = model.bonds[k];
    if (variant.two_laws || variant.two_widths) bond.number = k % 3 == 0;
    if (variant.mixed && k % 5 == 0) bond.law = Bond::Law::kParallelBond;
    if (variant.weighted) bond.weight = 0.3 + 0.1 * static_cast<double>(k % 7);
    if (variant.stressed)
      bond.at_rest = {-800.0 + static_cast<double>(k % 11), 30.0 * static_cast<double>(k % 3), 0};
  }
  return model;
}

// Shaken so that some bonds break.
test::Run shaken(const Model& model) {
  test::Run run(model, 0.3 * critical_step(model));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.25, 0.25);
  Particles& p = run.solver.particles();
  for (auto* values : {&p.vx, &p.vy, &p.spin})
    for (double& value : *values) value = any(random);
  return run;
}

// To the rounding of the sums.
void expect_same(const Stored& a, const Stored& b) {
  EXPECT_GT(a.sum(), 0);
  for (const auto part : {&Stored::contacts, &Stored::contact_bonds, &Stored::parallel_bonds})
    EXPECT_NEAR(a.*part, b.*part, 1e-12 * b.sum());
}

class ChunkKinds : public testing::TestWithParam<Variant> {};

TEST_P(ChunkKinds, ComputeWhatTheGeneralOneDoes) {
  const Model model = lattice(GetParam());
  test::Run plainest = shaken(model), general = shaken(model);
  const Pairs& bonds = plainest.solver.bonds();
  EXPECT_EQ(bonds.chunks[1].kind, GetParam().expected);
  for (Pairs::Chunk& chunk : general.solver.bonds().chunks) {
    chunk.kind = Kind::kGeneral;
    chunk.one_law = false;
  }
  plainest.steps(150);
  general.steps(150);
  const Particles &a = plainest.solver.particles(), &b = general.solver.particles();
  EXPECT_EQ(a.ux, b.ux);
  EXPECT_EQ(a.uy, b.uy);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(bonds.state, general.solver.bonds().state);
  const DiscLedger of_a = plainest.solver.ledger(), of_b = general.solver.ledger();
  EXPECT_EQ(of_a.friction, of_b.friction);
  EXPECT_EQ(of_a.released, of_b.released);
  EXPECT_EQ(of_a.dashpots, of_b.dashpots);
  expect_same(plainest.solver.strain_energy().pairs, general.solver.strain_energy().pairs);
  const auto broken = std::ranges::count_if(bonds.state, [](BondState s) { return s != BondState::kIntact; });
  EXPECT_GT(broken, 0);
  EXPECT_LT(broken, static_cast<std::ptrdiff_t>(bonds.size()) / 2);
}

INSTANTIATE_TEST_SUITE_P(
    All, ChunkKinds,
    testing::Values(
        Variant{.name = "ContactBonds", .expected = Kind::kPlain},
        Variant{.name = "ContactBondsWithDashpots", .dashpots = true, .expected = Kind::kPlain},
        Variant{
            .name = "StressedContactBonds", .dashpots = true, .stressed = true, .expected = Kind::kIntact},
        Variant{.name = "WeightedContactBondsOfTwoLaws",
                .weighted = true,
                .two_laws = true,
                .expected = Kind::kIntact},
        Variant{.name = "ParallelBonds", .parallel = true, .expected = Kind::kPlain},
        Variant{.name = "ParallelBondsWithDashpots",
                .parallel = true,
                .dashpots = true,
                .expected = Kind::kPlain},
        Variant{.name = "ParallelBondsOfTwoWidths",
                .parallel = true,
                .two_widths = true,
                .expected = Kind::kVaried},
        Variant{.name = "StressedParallelBonds",
                .parallel = true,
                .dashpots = true,
                .stressed = true,
                .weighted = true,
                .expected = Kind::kIntact},
        Variant{
            .name = "ContactAndParallelBonds", .dashpots = true, .mixed = true, .expected = Kind::kGeneral}),
    [](const auto& variant) { return variant.param.name; });

struct Touching {
  std::string name;
  bool dashpots = false, slack = false, weighted = false;
  Kind expected;
};
std::ostream& operator<<(std::ostream& out, const Touching& variant) {
  return out << variant.name;
}

// Discs that overlap a little and slide on each other.
Model packing(const Touching& variant) {
  Model model = lattice({.name = "", .dashpots = variant.dashpots, .expected = Kind::kPlain});
  model.bonds.clear();
  for (double& radius : model.discs.radius) radius *= 1.001;
  model.overlaps_free = variant.slack;
  for (std::size_t i = 0; variant.weighted && i < model.weight.size(); ++i)
    model.weight[i] = 0.3 + 0.1 * static_cast<double>(i % 7);
  return model;
}

class ContactKinds : public testing::TestWithParam<Touching> {};

TEST_P(ContactKinds, ComputeWhatTheGeneralOneDoes) {
  const Model model = packing(GetParam());
  test::Run plainest = shaken(model), general = shaken(model);
  Pairs& contacts = general.solver.neighbours().pairs();
  EXPECT_EQ(plainest.solver.contacts().chunks[1].kind, GetParam().expected);
  for (Pairs::Chunk& chunk : contacts.chunks) {
    chunk.kind = Kind::kGeneral;
    chunk.one_law = false;
  }
  plainest.steps(50);
  general.steps(50);
  EXPECT_EQ(general.solver.neighbours().lists(), 1);  // else the kinds would have been found anew
  const Particles &a = plainest.solver.particles(), &b = general.solver.particles();
  EXPECT_EQ(a.ux, b.ux);
  EXPECT_EQ(a.uy, b.uy);
  EXPECT_EQ(a.spin, b.spin);
  const DiscLedger of_a = plainest.solver.ledger(), of_b = general.solver.ledger();
  EXPECT_GT(of_a.friction, 0);
  EXPECT_EQ(of_a.friction, of_b.friction);
  EXPECT_EQ(of_a.dashpots, of_b.dashpots);
  expect_same(plainest.solver.strain_energy().pairs, general.solver.strain_energy().pairs);
}

INSTANTIATE_TEST_SUITE_P(
    All, ContactKinds,
    testing::Values(Touching{.name = "Pressed", .expected = Kind::kPlain},
                    Touching{.name = "PressedWithDashpots", .dashpots = true, .expected = Kind::kPlain},
                    Touching{.name = "FreeOfForceAtTheStart", .slack = true, .expected = Kind::kVaried},
                    Touching{
                        .name = "Weighted", .dashpots = true, .weighted = true, .expected = Kind::kIntact}),
    [](const auto& variant) { return variant.param.name; });

// While it relaxes, the kernel sums the internal forces that the pairs' states have.
TEST(InternalForce, IsThatOfTheStateReached) {
  Variant variant{.name = "", .stressed = true, .weighted = true, .expected = Kind::kIntact};
  test::Run run = shaken(lattice(variant));
  const double before = run.solver.internal_force();
  EXPECT_GT(before, 0);
  PrescribedMotions none;
  for (std::uint64_t n = 1; n <= 20; ++n)
    run.solver.step({.number = n, .dt = run.dt, .relax = true}, test::no_loads, none);
  double sum = 0;
  for (std::uint32_t k = 0; k < run.solver.bonds().size(); ++k) {
    const PairState s = state_of(k, run.solver.laws(), run.solver.particles(), run.solver.bonds());
    sum += run.solver.bonds().weight[k] * std::hypot(s.bond_normal + s.contact_normal, s.shear);
  }
  EXPECT_NE(sum, before);
  EXPECT_NEAR(run.solver.internal_force(), sum, 1e-12 * sum);
}

}  // namespace
}  // namespace adit::dem::chunk_kinds_test
