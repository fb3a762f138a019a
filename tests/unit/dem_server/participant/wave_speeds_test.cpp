// Requirement: the wave speeds that particles report are those of the stiffness that their bonds really have.
#include "dem_server/participant/wave_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem_server/model/calibration.hpp"
#include "dem_server/packing/regular.hpp"

namespace adit::dem::wave_speeds_test {
namespace {

constexpr double kRadius = 0.07, kDensity = 2400;

// A hexagonal lattice so wide that most particles are inside it, in one group and bonded by the first law of
// a kind.
Model lattice(Bond::Law law, const geometry::BoundingBox& box = {0, 3, 0, 2}, double radius = kRadius) {
  Model model;
  model.discs = pack_hexagonally(box, radius).discs;
  const std::size_t size = model.discs.size();
  model.mass.assign(size, cell_mass(kDensity, radius));
  model.group.assign(size, 0);
  model.group_names = {"", "soft"};
  model.contacts.assign(4, {.normal_stiffness = 3e8, .shear_stiffness = 1e8, .friction = 0.5});
  for (const Pair& pair : pairs_within(model.discs, 1e-6 * radius))
    model.bonds.push_back({pair.first, pair.second, law, 0});
  return model;
}

WaveSpeeds of_lattice(const BondStiffness& stiffness) {
  Model model = lattice(Bond::Law::kContactBond);
  model.contact_bonds = {{.stiffness = stiffness}};
  return wave_speeds(model);
}

void expect_equal(const WaveSpeeds& speeds, const WaveSpeeds& expected) {
  EXPECT_NEAR(speeds.p, expected.p, 1e-9 * expected.p);
  EXPECT_NEAR(speeds.s, expected.s, 1e-9 * expected.s);
}

// Bonds calibrated from a material let waves run as fast as the material does, in either plane condition.
TEST(WaveSpeeds, OfACalibratedLatticeAreTheSolids) {
  const double e = 25e9, nu = 0.2, mu = e / (2 * (1 + nu));
  for (const Plane plane : {Plane::kStress, Plane::kStrain}) {
    const double lambda =
        plane == Plane::kStress ? e * nu / (1 - nu * nu) : e * nu / ((1 + nu) * (1 - 2 * nu));
    expect_equal(of_lattice(calibrate(e, nu, plane)),
                 {std::sqrt((lambda + 2 * mu) / kDensity), std::sqrt(mu / kDensity)});
  }
}

// Stiffnesses that a scene gives count, not the modulus that they replace.
TEST(WaveSpeeds, FollowTheStiffnessOfTheBonds) {
  const double factor = std::numbers::sqrt3 / 4 / kDensity;
  expect_equal(of_lattice({1e9, 2e8}), {std::sqrt(3.2e9 * factor), std::sqrt(1.2e9 * factor)});
  expect_equal(of_lattice({4e9, 0}), {std::sqrt(12e9 * factor), std::sqrt(4e9 * factor)});
}

// A row of particles is a chain of springs: c = a sqrt(k / m).
TEST(WaveSpeeds, OfARowAreThoseOfAChain) {
  Model row = lattice(Bond::Law::kContactBond, {0, 40, 0, std::numbers::sqrt3 / 2}, 0.5);
  ASSERT_EQ(row.bonds.size() + 1, row.discs.size());
  row.contact_bonds = {{.stiffness = {9, 0}}};
  row.mass.assign(row.discs.size(), 0.25);
  EXPECT_NEAR(wave_speeds(row).p, 6, 1e-12);
}

// Parallel bonds act beside the contacts below them.
TEST(WaveSpeeds, OfParallelBondsAreThoseOfBothSprings) {
  Model model = lattice(Bond::Law::kParallelBond);
  model.parallel_bonds = {{.normal_stiffness = 1e10,
                           .shear_stiffness = 2e9,
                           .radius = kRadius,
                           .tensile_strength = 1,
                           .cohesion = 1,
                           .tan_friction_angle = 0}};
  expect_equal(wave_speeds(model), of_lattice({1e10 * 2 * kRadius + 3e8, 2e9 * 2 * kRadius + 1e8}));
}

TEST(WaveSpeeds, OfSpringsAreThoseOfBondsWithoutShear) {
  Model model = lattice(Bond::Law::kContactBond);
  for (const Bond& bond : model.bonds) model.springs.push_back({bond.first, bond.second, 5e8, false, 0, 1});
  model.bonds.clear();
  expect_equal(wave_speeds(model), of_lattice({5e8, 0}));
}

TEST(WaveSpeeds, AreThoseOfTheFastestGroup) {
  Model model = lattice(Bond::Law::kContactBond);
  model.contact_bonds = {{.stiffness = {1e9, 2e8}}, {.stiffness = {1e7, 2e6}}};
  for (std::size_t i = 0; i < model.discs.size(); ++i) model.group[i] = model.discs.x[i] > 1 ? 1 : 0;
  for (Bond& bond : model.bonds) bond.number = std::max(model.group[bond.first], model.group[bond.second]);
  expect_equal(wave_speeds(model), of_lattice({1e9, 2e8}));
}

// Ten particles make the shortest shear wave that the model carries well; the softest group decides.
TEST(HighestFrequency, IsThatOfTenParticlesInTheSoftestGroup) {
  Model model = lattice(Bond::Law::kContactBond);
  model.contact_bonds = {{.stiffness = {1e9, 2e8}}, {.stiffness = {1e7, 2e6}}};
  for (std::size_t i = 0; i < model.discs.size(); ++i) model.group[i] = model.discs.x[i] > 1 ? 1 : 0;
  for (Bond& bond : model.bonds) bond.number = std::max(model.group[bond.first], model.group[bond.second]);
  const double expected = of_lattice({1e7, 2e6}).s / (10 * 2 * kRadius);
  EXPECT_NEAR(highest_frequency(model), expected, 1e-9 * expected);
  model.bonds.clear();
  EXPECT_EQ(highest_frequency(model), 0);
}

// Without bonds nothing carries a wave yet.
TEST(WaveSpeeds, AreNotKnownWithoutBonds) {
  Model model = lattice(Bond::Law::kContactBond);
  model.bonds.clear();
  EXPECT_EQ(wave_speeds(model).p, 0);
  EXPECT_EQ(wave_speeds(model).s, 0);
}

}  // namespace
}  // namespace adit::dem::wave_speeds_test
