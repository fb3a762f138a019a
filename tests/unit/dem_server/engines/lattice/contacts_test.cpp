// Requirements on contacts between particles that no bond joins.
#include "dem_server/engines/lattice/contacts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/unit/dem_server/cantilever_scene.hpp"
#include "tests/unit/dem_server/engines/lattice/lattice.hpp"

namespace adit::dem::contacts_test {
namespace {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}

// Discs of sizes 1 : 50, some of them far away, some at infinity or nowhere: the pairs are those of a search
// through all.
RC_GTEST_PROP(Pairs, AreThoseOfAFullSearch, ()) {
  Discs discs;
  const int count = *rc::gen::inRange(0, 80);
  for (int i = 0; i < count; ++i) {
    const double far = *rc::gen::element(1.0, 1.0, 1.0, 1e3, 1e12, HUGE_VAL, std::nan(""));
    discs.x.push_back(far * between(-3, 3));
    discs.y.push_back(between(-3, 3));
    discs.radius.push_back(between(0.02, 1));
  }
  const double reach = between(0, 0.5);
  std::vector<Pair> expected;
  for (std::uint32_t i = 0; i < discs.size(); ++i)
    for (std::uint32_t j = i + 1; j < discs.size(); ++j)
      if (std::hypot(discs.x[i] - discs.x[j], discs.y[i] - discs.y[j]) <=
          discs.radius[i] + discs.radius[j] + reach)
        expected.push_back({i, j});
  RC_ASSERT(pairs_within(discs, reach) == expected);
}

// A lattice of discs that no bond joins, thrown about: in every step of a long motion each pair that overlaps
// is in the list, and lists are made only when some disc has moved by half the skin, a quarter of a radius,
// less what two steps move it.
TEST(Contacts, ListHoldsAllThatTouchAndIsMadeNoSooner) {
  Assembly a = test::assemble(test::rows_of(12, 12), 1.0);
  a.bonds = Bonds{};
  a.bonds.rest_length = 1;
  a.bonds.finish();
  Particles& p = a.particles;
  test::fill_randomly(p.vx, 1, 1);
  test::fill_randomly(p.vy, 1, 2);
  Contacts contacts(a);
  const double dt = 0.004;
  const protocol::IndexRange all{0, static_cast<std::uint32_t>(p.size())};
  auto listed = p;
  std::uint64_t lists = contacts.lists();
  for (int n = 0; n < 600; ++n) {
    double farthest = 0, fastest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      farthest = std::max(farthest, std::hypot(p.ux[i] - listed.ux[i], p.uy[i] - listed.uy[i]));
      fastest = std::max(fastest, std::hypot(p.vx[i], p.vy[i]));
    }
    if (contacts.update(dt, a)) {
      EXPECT_GT(farthest, 0.125 - 2.001 * dt * fastest);
      listed = p;
    } else {
      EXPECT_LE(farthest, 0.125);
    }
    contacts.moved(dt, std::sqrt(move(dt, {&all, 1}, p)));
    std::size_t touching = 0, found = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = i + 1; j < p.size(); ++j)
        touching += std::hypot(p.x[j] - p.x[i] + p.ux[j] - p.ux[i], p.y[j] - p.y[i] + p.uy[j] - p.uy[i]) < 1;
    for (const auto [i, j] : contacts.pairs())
      found += std::hypot(p.x[j] - p.x[i] + p.ux[j] - p.ux[i], p.y[j] - p.y[i] + p.uy[j] - p.uy[i]) < 1;
    ASSERT_EQ(found, touching) << n;
  }
  EXPECT_GT(contacts.lists(), lists + 4);
}

// Bonded pairs are not contacts, broken or not: the bond's own law holds.
TEST(Contacts, LeaveBondedPairsAlone) {
  Assembly a = test::assemble(test::rows_of(5, 9), 1.0);
  a.bonds.break_bond(3, BondState::kShearCrack);
  EXPECT_THAT(Contacts(a).pairs(), testing::IsEmpty());
}

// Fn = kn times the overlap on both, along the line between them; its work is the strain energy.
TEST(Contacts, PushByTheOverlap) {
  Assembly a = test::assemble(test::rows_of(1, 3), 1.0);
  Particles& p = a.particles;
  p.ux[2] = -1 - 0.3;  // 0.7 from the first
  p.uy[2] = 0.4;
  p.weight = {0.5, 1, 0.25};
  const std::vector<Pair> pairs{{0, 2}};
  const double length = std::hypot(0.7, 0.4), kn = 7, weight = 0.375;
  add_contacts(kn, 1, pairs, p, resultants_of(p));
  EXPECT_NEAR(p.fx[2], weight * kn * (1 - length) * 0.7 / length, 1e-14);
  EXPECT_NEAR(p.fy[2], weight * kn * (1 - length) * 0.4 / length, 1e-14);
  EXPECT_EQ(p.fx[0], -p.fx[2]);
  EXPECT_EQ(p.fy[0], -p.fy[2]);
  EXPECT_EQ(p.moment[0], 0);
  EXPECT_NEAR(contact_energy(kn, 1, pairs, p), weight * kn * (1 - length) * (1 - length) / 2, 1e-14);
  p.ux[2] = 0;
  add_contacts(kn, 1, pairs, p, resultants_of(p));
  EXPECT_EQ(contact_energy(kn, 1, pairs, p), 0);
}

// A beam cut in two by a blow whose halves meet again: new contacts bounce them apart, and the ledger of
// kinetic, strain and released energy against the work closes.
TEST(Contacts, BounceBrokenPieces) {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_time()->set_duration(1);
  auto& material = *scene.mutable_material();
  material.set_young_modulus(1e9);
  material.set_poisson_ratio(0.2);
  material.set_density(2000);
  auto& particles = *scene.mutable_particles();
  auto& packing = *particles.mutable_packing();
  packing.set_x_min(0);
  packing.set_x_max(6);
  packing.set_y_min(0);
  packing.set_y_max(1.8);
  packing.set_radius(0.25);
  particles.mutable_bonds()->set_tensile_strength(1e4);
  auto& pull = *particles.add_loads();  // apart, then against each other and sideways
  pull.mutable_where()->set_x_max(0.3);
  pull.mutable_force()->set_x(-2e6);
  pull.mutable_force()->set_y(1e5);
  auto& table = *pull.mutable_time()->mutable_table();
  for (const double t : {0.0, 0.004, 0.0041, 0.012, 0.0121}) table.add_time(t);
  for (const double f : {1.0, 1.0, -1.0, -1.0, 0.0}) table.add_value(f);
  test::InProcessRun run(scene, {}, 0.1);
  double largest = 0, imbalance = 0;
  std::size_t cracks = 0;
  for (int n = 0; n < 4000; ++n) {
    const auto& predicted = run.advance();
    cracks += static_cast<std::size_t>(predicted.cracks_size());
    const auto& e = predicted.energies();
    largest = std::max(largest, e.kinetic() + e.strain());
    imbalance = std::max(imbalance, std::abs(e.kinetic() + e.strain() + e.released() - e.external_work()));
  }
  EXPECT_GT(cracks, 3u);
  EXPECT_LT(imbalance, 1e-3 * largest);
}

}  // namespace
}  // namespace adit::dem::contacts_test
