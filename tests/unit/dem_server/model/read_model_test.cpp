// A scene of discs as a model: what is packed, joined, taken away, weighed.
#include "dem_server/model/reading/read_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>

#include "dem_server/model/calibration.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/results/vtk.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::read_model_test {
namespace {

using testing::HasSubstr;
using Law = Bond::Law;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::ptrdiff_t count(const Model& model, Law law) {
  return std::ranges::count(model.bonds, law, &Bond::law);
}

scene::ParticleJoint& add_joint(scene::Scene& scene, double x_1, double y_1, double x_2, double y_2) {
  auto& joint = *scene.mutable_particles()->add_joints();
  test::set(*joint.mutable_from(), x_1, y_1);
  test::set(*joint.mutable_to(), x_2, y_2);
  return joint;
}

void set_parallel(scene::Bonds& bonds) {
  bonds.mutable_parallel()->set_normal_stiffness(2e11);
  bonds.mutable_parallel()->set_shear_stiffness(1e11);
}

// Lattices stand for the solid of their cells: mass = density times their area, to rounding.
TEST(ReadModel, WeighsLatticesByTheirCells) {
  const Model square = read_model(test::square_scene(6, 4));
  ASSERT_EQ(square.discs.size(), 24u);
  EXPECT_NEAR(sum(square.mass), test::kDensity * 24, 1e-9);
  EXPECT_NEAR(square.inertia(3), test::kDensity * 0.25 / 2, 1e-12);

  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 4, std::sqrt(3.0) * 0.5 * 4);
  packing.set_radius(0.5);
  const Model hexagonal = read_model(scene);
  ASSERT_EQ(hexagonal.discs.size(), 14u);
  EXPECT_NEAR(hexagonal.mass[0], cell_mass(test::kDensity, 0.5), 1e-12);
}

// A random packing stands for its whole box, whatever its porosity; cutting it leaves the discs' masses.
TEST(ReadModel, WeighsARandomPackingByItsBox) {
  auto scene = test::random_scene();
  const Model whole = read_model(scene);
  EXPECT_NEAR(sum(whole.mass), test::kDensity * 2, 1e-9);
  scene.mutable_particles()->mutable_within()->set_x_max(1);
  const Model half = read_model(scene);
  EXPECT_LT(half.discs.size(), whole.discs.size());
  EXPECT_NEAR(sum(half.mass), test::kDensity, 0.05 * test::kDensity);
  EXPECT_NEAR(half.mass[0] / half.discs.radius[0] / half.discs.radius[0],
              whole.mass[0] / whole.discs.radius[0] / whole.discs.radius[0], 1e-9);
}

// Placed discs weigh what they are.
TEST(ReadModel, WeighsPlacedDiscsByTheirArea) {
  const Model model = read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,0.5\n3,0,2\n"));
  EXPECT_NEAR(model.mass[0], test::kDensity * std::numbers::pi / 4, 1e-9);
  EXPECT_NEAR(model.inertia(1), test::kDensity * 4 * std::numbers::pi * 2, 1e-6);
}

// Frictionless discs jam near a porosity of 0.16, floaters included, with four contacts each (walls take
// some); the same seed gives the same discs to the bit; the user reads what was reached.
TEST(ReadModel, PacksRandomlyAndSaysWhatItReached) {
  auto scene = test::random_scene();
  const Model model = read_model(scene), again = read_model(scene);
  EXPECT_EQ(model.discs.x, again.discs.x);
  EXPECT_EQ(model.discs.y, again.discs.y);
  EXPECT_EQ(model.discs.radius, again.discs.radius);
  const double coordination =
      2.0 * static_cast<double>(model.bonds.size()) / static_cast<double>(model.discs.size());
  EXPECT_GT(coordination, 3.5);
  EXPECT_LT(coordination, 4.5);
  ASSERT_EQ(model.notes.size(), 2u);
  EXPECT_THAT(model.notes[0], HasSubstr("contacts a particle"));
  EXPECT_THAT(model.notes[0], HasSubstr("(1e+07 Pa wanted)"));
  EXPECT_THAT(model.notes[1], HasSubstr("only an estimate"));

  auto& packing = *scene.mutable_particles()->mutable_random_packing();
  packing.set_keep_floaters(true);
  double area = 0;
  for (const double r : read_model(scene).discs.radius) area += std::numbers::pi * r * r;
  EXPECT_NEAR(1 - area / 2, 0.17, 0.02);
  packing.set_seed(2);
  EXPECT_NE(read_model(scene).discs.x, model.discs.x);
}

// Contacts are taken as free of force where they are, unless the packing's stress is to be kept.
TEST(ReadModel, KeepsTheStressOfThePackingWhereAsked) {
  auto scene = test::random_scene();
  EXPECT_TRUE(read_model(scene).overlaps_free);
  scene.mutable_particles()->mutable_random_packing()->set_keep_stress(true);
  EXPECT_FALSE(read_model(scene).overlaps_free);
  EXPECT_FALSE(read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,1\n")).overlaps_free);
}

// Without words for them particles are bonded as the lattice of the material is; with contacts alone they
// only touch.
TEST(ReadModel, BondsUnlessThereAreContactsAlone) {
  auto scene = test::square_scene(3, 3);
  const Model bonded = read_model(scene);
  const BondStiffness expected = calibrate(10e9, 0.2, Plane::kStress);
  ASSERT_EQ(bonded.bonds.size(), 12u);
  ASSERT_EQ(bonded.contact_bonds.size(), 1u);
  EXPECT_EQ(bonded.contact_bonds[0].stiffness.normal, expected.normal);
  EXPECT_EQ(bonded.contact_bonds[0].tensile_strength, kUnbreakable);
  EXPECT_EQ(bonded.contacts[0].shear_stiffness, expected.shear);

  scene.mutable_particles()->mutable_contacts()->set_friction(0.5);
  const Model loose = read_model(scene);
  EXPECT_TRUE(loose.bonds.empty());
  EXPECT_THAT(loose.notes, testing::Contains(HasSubstr("only touch")));
  EXPECT_EQ(loose.contacts[0].friction, 0.5);
  EXPECT_EQ(loose.contacts[0].normal_stiffness, expected.normal);

  scene.mutable_particles()->mutable_bonds()->set_normal_stiffness(3e9);
  const Model both = read_model(scene);
  EXPECT_EQ(both.bonds.size(), 12u);
  EXPECT_EQ(both.contacts[0].normal_stiffness, 3e9);
}

// Discs within reach are joined: in square packing the diagonals' gap is 2 (sqrt 2 - 1) of the radius.
TEST(ReadModel, JoinsWhatIsWithinReach) {
  auto scene = test::square_scene(3, 3);
  scene.mutable_particles()->mutable_bonds()->set_reach(0.83);
  EXPECT_EQ(read_model(scene).bonds.size(), 20u);
  scene.mutable_particles()->mutable_bonds()->set_reach(0.82);
  EXPECT_EQ(read_model(scene).bonds.size(), 12u);
}

// A strip of cement is as wide as the smaller disc times the share, each width once.
TEST(ReadModel, WidthOfCementFollowsTheSmallerDisc) {
  auto scene = test::placed_scene("x_m,y_m,radius_m\n0,0,1\n1.5,0,0.5\n-2,0,1\n3,0,1\n");
  auto& bonds = *scene.mutable_particles()->mutable_bonds();
  set_parallel(bonds);
  bonds.mutable_parallel()->set_width(0.8);
  bonds.mutable_parallel()->set_friction_angle(std::numbers::pi / 4);
  const Model model = read_model(scene);
  ASSERT_EQ(model.bonds.size(), 3u);
  ASSERT_EQ(model.parallel_bonds.size(), 2u);
  EXPECT_DOUBLE_EQ(model.parallel_bonds[model.bonds[0].number].radius, 0.4);  // 0 and 1
  EXPECT_DOUBLE_EQ(model.parallel_bonds[model.bonds[1].number].radius, 0.8);  // 0 and 2
  EXPECT_EQ(model.bonds[2].number, model.bonds[0].number);                    // 1 and 3
  EXPECT_NEAR(model.parallel_bonds[0].tan_friction_angle, 1, 1e-15);
  EXPECT_EQ(model.contacts[0].normal_stiffness, calibrate(10e9, 0.2, Plane::kStress).normal);
}

// Groups: material, bonds and contacts of their own; between two, stiffnesses in series and the smaller
// strengths.
TEST(ReadModel, GroupsHaveTheirOwnBonds) {
  auto scene = test::square_scene(4, 1);
  auto& p = *scene.mutable_particles();
  p.mutable_bonds()->set_normal_stiffness(1e9);
  p.mutable_bonds()->set_shear_stiffness(4e8);
  p.mutable_bonds()->set_tensile_strength(500);
  auto& lining = *p.add_groups();
  lining.set_name("lining");
  lining.mutable_where()->set_x_min(2);
  lining.mutable_material()->CopyFrom(scene.material());
  lining.mutable_material()->set_density(5000);
  lining.mutable_bonds()->set_normal_stiffness(3e9);
  lining.mutable_bonds()->set_shear_stiffness(0);
  lining.mutable_contacts()->set_friction(0.3);
  const Model model = read_model(scene);
  EXPECT_EQ(model.group_names, (std::vector<std::string>{"particles", "lining"}));
  EXPECT_EQ(model.group, (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(model.mass, (std::vector<double>{2500, 2500, 5000, 5000}));
  ASSERT_EQ(model.bonds.size(), 3u);
  const auto& middle = model.contact_bonds[model.bonds[1].number];
  EXPECT_DOUBLE_EQ(middle.stiffness.normal, 1.5e9);
  EXPECT_EQ(middle.stiffness.shear, 0);
  EXPECT_EQ(middle.tensile_strength, 500);
  EXPECT_EQ(model.contact_bonds[model.bonds[2].number].tensile_strength, kUnbreakable);
  EXPECT_DOUBLE_EQ(model.contacts[1].normal_stiffness, 1.5e9);
  EXPECT_EQ(model.contacts[1].friction, 0);
  EXPECT_EQ(model.contacts[2], model.contacts[1]);
  EXPECT_EQ(model.contacts[3].friction, 0.3);

  auto& between = *p.add_between();
  between.set_first("lining");
  between.set_second("particles");
  EXPECT_EQ(read_model(scene).bonds.size(), 2u);
  set_parallel(*between.mutable_bonds());
  EXPECT_EQ(count(read_model(scene), Law::kParallelBond), 1);
}

// Groups by the numbers of the table.
TEST(ReadModel, TableNumbersGroups) {
  auto scene = test::placed_scene("group,x_m,y_m,radius_m\n7,0,0,0.5\n\n 3 ,1,0,0.5\r\n7,2,0,0.5\n");
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("gouge");
  group.set_number(7);
  EXPECT_EQ(read_model(scene).group, (std::vector<std::uint32_t>{1, 0, 1}));
}

// A line along y = 2 and x < 2 parts exactly the upright bonds of the first two columns between the second
// and third row.
TEST(ReadModel, JointPartsExactlyTheBondsItCrosses) {
  auto scene = test::square_scene(4, 4);
  auto& joint = add_joint(scene, -1, 2, 2, 2);
  joint.mutable_smooth()->set_normal_stiffness(1e9);
  joint.mutable_smooth()->set_shear_stiffness(5e8);
  joint.mutable_smooth()->set_dilation(0.1);
  const Model model = read_model(scene);
  EXPECT_EQ(model.bonds.size(), 24u);
  std::set<std::pair<std::uint32_t, std::uint32_t>> smooth;
  for (const Bond& bond : model.bonds)
    if (bond.law == Law::kSmoothJoint) {
      smooth.insert({bond.first, bond.second});
      EXPECT_NEAR(bond.nx, 0, 1e-15);
      EXPECT_NEAR(bond.ny, 1, 1e-15);  // upwards, from the lower first to the upper second disc
    }
  EXPECT_EQ(smooth, (std::set<std::pair<std::uint32_t, std::uint32_t>>{{4, 8}, {5, 9}}));
  ASSERT_EQ(model.smooth_joints.size(), 1u);
  EXPECT_EQ(model.smooth_joints[0].length, 1);
  EXPECT_NEAR(model.smooth_joints[0].tan_dilation, std::tan(0.1), 1e-15);

  add_joint(scene, 1, 0, 1, 4).set_open(true);  // a later line, upright, parts four level bonds
  EXPECT_EQ(read_model(scene).bonds.size(), 20u);
  auto& last = add_joint(scene, 1, 0, 1, 4);  // the last holds
  last.mutable_bonds()->set_tensile_strength(7);
  const Model with_bonds = [&] {
    scene.mutable_particles()->mutable_joints()->SwapElements(1, 2);
    scene.mutable_particles()->mutable_joints()->RemoveLast();
    return read_model(scene);
  }();
  EXPECT_EQ(with_bonds.bonds.size(), 24u);
  EXPECT_EQ(std::ranges::count_if(with_bonds.bonds,
                                  [&](const Bond& j) {
                                    return j.law == Law::kContactBond &&
                                           with_bonds.contact_bonds[j.number].tensile_strength == 7;
                                  }),
            4);
}

// The plane's normal points from the first disc's side to the second's, whichever way the line is drawn.
TEST(ReadModel, NormalOfAJointFollowsTheDiscs) {
  for (const bool reversed : {false, true}) {
    auto scene = test::square_scene(2, 1);
    auto& joint = reversed ? add_joint(scene, 1.3, 1, 0.7, 0) : add_joint(scene, 0.7, 0, 1.3, 1);
    joint.mutable_smooth()->set_normal_stiffness(1e9);
    joint.mutable_smooth()->set_shear_stiffness(5e8);
    const Bond bond = read_model(scene).bonds.at(0);
    EXPECT_NEAR(bond.nx, 1 / std::hypot(1, 0.6), 1e-15);
    EXPECT_NEAR(bond.ny, -0.6 / std::hypot(1, 0.6), 1e-15);
  }
}

scene::Scene ring_scene(std::uint32_t segments) {
  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_packing();
  packing.set_x_min(-3.5);
  packing.set_x_max(3.5);
  packing.set_y_min(-3.5);
  packing.set_y_max(3.5);
  packing.set_radius(0.05);
  auto& ring = *scene.mutable_particles()->mutable_ring();
  test::set(*ring.mutable_centre(), 0, 0);
  ring.set_inner_radius(2.5);
  ring.set_outer_radius(3);
  ring.set_segments(segments);
  ring.set_first_joint(0.3);
  return scene;
}

// What lies between the circles remains; joints part exactly the bonds whose discs lie in different segments.
TEST(ReadModel, RingHasItsSegmentsAndJoints) {
  auto scene = ring_scene(6);
  const Model parted = read_model(scene);
  for (std::size_t i = 0; i < parted.discs.size(); ++i) {
    const double r = std::hypot(parted.discs.x[i], parted.discs.y[i]);
    EXPECT_GE(r, 2.5 - 1e-6);
    EXPECT_LE(r, 3 + 1e-6);
  }
  const auto segment = [&](std::uint32_t i) {
    const double angle = std::atan2(parted.discs.y[i], parted.discs.x[i]) - 0.3 + 4 * std::numbers::pi;
    return static_cast<int>(std::floor(angle / (std::numbers::pi / 3))) % 6;
  };
  for (const Bond& bond : parted.bonds) EXPECT_EQ(segment(bond.first), segment(bond.second));

  scene.mutable_particles()->mutable_ring()->mutable_joints()->set_tensile_strength(1e3);
  const Model jointed = read_model(scene);
  const auto across = std::ranges::count_if(jointed.bonds, [&](const Bond& j) {
    const bool weak = jointed.contact_bonds[j.number].tensile_strength == 1e3;
    EXPECT_EQ(weak, segment(j.first) != segment(j.second));
    return weak;
  });
  EXPECT_EQ(jointed.bonds.size() - parted.bonds.size(), static_cast<std::size_t>(across));
  EXPECT_GE(across, 6 * 5);  // five rows of discs or more at each joint

  // A ring of one segment is slit once.
  const auto slit = read_model(ring_scene(1)).bonds.size();
  EXPECT_GE(jointed.bonds.size() - slit, 5u);
  EXPECT_LE(jointed.bonds.size() - slit, 12u);
}

// Within ground, the particles of the ring are the group `lining` and the ground around stays; joints part
// the lining alone, and `between` says how the ground holds it.
TEST(ReadModel, RingWithinGroundIsALining) {
  auto scene = ring_scene(6);
  scene.mutable_particles()->mutable_ring()->set_within_ground(true);
  const auto is_lining = [](const Model& model, std::uint32_t i) {
    return model.group_names[model.group[i]] == "lining";
  };
  const Model bonded = read_model(scene);
  for (std::uint32_t i = 0; i < bonded.discs.size(); ++i) {
    const double r = std::hypot(bonded.discs.x[i], bonded.discs.y[i]);
    EXPECT_GE(r, 2.5 - 1e-6);
    EXPECT_EQ(is_lining(bonded, i), r <= 3 + 1e-6);
  }
  EXPECT_GT(std::ranges::max(bonded.discs.x), 3.4);
  const auto meets_ground = [&](const Model& model) {
    return std::ranges::count_if(
        model.bonds, [&](const Bond& b) { return is_lining(model, b.first) != is_lining(model, b.second); });
  };
  const auto segment = [&](std::uint32_t i) {
    const double angle = std::atan2(bonded.discs.y[i], bonded.discs.x[i]) - 0.3 + 4 * std::numbers::pi;
    return static_cast<int>(std::floor(angle / (std::numbers::pi / 3))) % 6;
  };
  std::size_t across_in_ground = 0;
  for (const Bond& bond : bonded.bonds) {
    if (segment(bond.first) == segment(bond.second)) continue;
    EXPECT_FALSE(is_lining(bonded, bond.first) && is_lining(bonded, bond.second));
    ++across_in_ground;
  }
  EXPECT_GT(across_in_ground, 6u);
  EXPECT_GT(meets_ground(bonded), 100);

  auto& between = *scene.mutable_particles()->add_between();
  between.set_first("lining");
  between.set_second("particles");
  EXPECT_EQ(meets_ground(read_model(scene)), 0);
}

// The group of the lining takes its properties from the scene's group of this name, whatever other group
// selects its places.
TEST(ReadModel, TheLiningOfARingHasItsOwnProperties) {
  auto scene = ring_scene(1);
  scene.mutable_particles()->mutable_ring()->set_within_ground(true);
  auto& lining = *scene.mutable_particles()->add_groups();
  lining.set_name("lining");
  *lining.mutable_material() = scene.material();
  lining.mutable_material()->set_density(2 * scene.material().density());
  auto& fault = *scene.mutable_particles()->add_groups();
  fault.set_name("fault");
  fault.mutable_where()->set_x_min(2);
  const Model model = read_model(scene);
  EXPECT_EQ(model.group_names, (std::vector<std::string>{"particles", "lining", "fault"}));
  const double light = std::ranges::min(model.mass);
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    const bool in_ring = std::hypot(model.discs.x[i], model.discs.y[i]) <= 3 + 1e-6;
    EXPECT_DOUBLE_EQ(model.mass[i], in_ring ? 2 * light : light);
    EXPECT_EQ(model.group[i], in_ring ? 1u : model.discs.x[i] >= 2 ? 2u : 0u);
  }
}

// One bolt across each joint, tension only, in the middle of the lining, from one segment to the next.
TEST(ReadModel, RingHasBoltsAcrossItsJoints) {
  auto scene = ring_scene(6);
  auto& bolts = *scene.mutable_particles()->mutable_ring()->mutable_bolts();
  bolts.set_length(0.4);
  bolts.set_stiffness(1e8);
  bolts.set_pretension(2e4);
  const Model model = read_model(scene);
  ASSERT_EQ(model.springs.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const Spring& bolt = model.springs[k];
    const double angle = 0.3 + static_cast<double>(k) * std::numbers::pi / 3;
    const auto along = [&](std::uint32_t i) {
      return model.discs.y[i] * std::cos(angle) - model.discs.x[i] * std::sin(angle);
    };
    EXPECT_NEAR(along(bolt.first), -0.2, 0.1);
    EXPECT_NEAR(along(bolt.second), 0.2, 0.1);
    EXPECT_NEAR(std::hypot(model.discs.x[bolt.first], model.discs.y[bolt.first]), 2.75, 0.1);
    EXPECT_TRUE(bolt.tension_only);
    EXPECT_EQ(bolt.pretension, 2e4);
  }
}

// A chain on a triangle of discs goes, link after link, and the user reads how many went.
TEST(ReadModel, TakesFloatersAwayUntilThereAreNone) {
  auto scene = test::empty_scene();
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 6, std::sqrt(3.0) * 0.5 * 6);
  packing.set_radius(0.5);
  const Model whole = read_model(scene);
  scene.mutable_particles()->set_remove_floaters(true);
  const Model held = read_model(scene);
  std::vector<int> neighbours(held.discs.size(), 0);
  for (const Bond& bond : held.bonds) {
    ++neighbours[bond.first];
    ++neighbours[bond.second];
  }
  EXPECT_GE(std::ranges::min(neighbours), 3);
  ASSERT_LT(held.discs.size(), whole.discs.size());  // corners have two neighbours
  EXPECT_THAT(held.notes.at(0),
              HasSubstr(std::to_string(whole.discs.size() - held.discs.size()) + " particles"));
  EXPECT_EQ(held.mass.size(), held.discs.size());
}

// Springs join the discs nearest to their ends.
TEST(ReadModel, SpringsFindTheirDiscs) {
  auto scene = test::square_scene(3, 1);
  auto& spring = *scene.mutable_particles()->add_springs();
  test::set(*spring.mutable_from(), 0.1, 0.9);
  test::set(*spring.mutable_to(), 2.4, 0.4);
  spring.set_stiffness(1e6);
  spring.set_strength(1e3);
  const Spring found = read_model(scene).springs.at(0);
  EXPECT_EQ(found.first, 0u);
  EXPECT_EQ(found.second, 2u);
  EXPECT_EQ(found.strength, 1e3);
}

// A side's dashpots add up to its impedance: length times sqrt(rho modulus), however its discs lie; a corner
// has both.
TEST(ReadModel, QuietEdgesHaveTheImpedanceOfTheirSide) {
  auto scene = test::square_scene(5, 8);
  auto& left = *scene.mutable_particles()->add_quiet();
  left.mutable_where()->set_x_max(0.6);
  left.set_side(scene::QuietParticles::LEFT);
  const double p = std::sqrt(test::kDensity * 10e9 / 0.96), s = std::sqrt(test::kDensity * 10e9 / 2.4);
  const auto total = [](const Model& model) {
    std::array<double, 2> total{};
    for (const EdgeDashpot& edge : model.edges) {
      total[0] += edge.damping_x;
      total[1] += edge.damping_y;
    }
    return total;
  };
  const Model one = read_model(scene);
  EXPECT_EQ(one.edges.size(), 8u);
  EXPECT_NEAR(total(one)[0], 8 * p, 1e-9 * p);
  EXPECT_NEAR(total(one)[1], 8 * s, 1e-9 * s);
  auto& lower = *scene.mutable_particles()->add_quiet();
  lower.mutable_where()->set_y_max(0.6);
  lower.set_side(scene::QuietParticles::LOWER);
  const Model two = read_model(scene);
  EXPECT_EQ(two.edges.size(), 12u);
  EXPECT_NEAR(two.edges[0].damping_x, p + s, 1e-9 * p);
  EXPECT_NEAR(total(two)[1], 8 * s + 5 * p, 1e-9 * p);

  auto random = test::random_scene();
  auto& upper = *random.mutable_particles()->add_quiet();
  upper.mutable_where()->set_y_min(0.9);
  upper.set_side(scene::QuietParticles::UPPER);
  random.mutable_particles()->mutable_random_packing()->set_keep_floaters(true);  // no holes at the rim
  EXPECT_NEAR(total(read_model(random))[1], 2 * p, 0.03 * p);
}

// Walls: their own contacts, or the particles'; what they leave out are the particles' stiffnesses.
TEST(ReadModel, WallsHaveContacts) {
  auto scene = test::square_scene(2, 1);
  auto& p = *scene.mutable_particles();
  p.mutable_bonds();
  p.mutable_contacts()->set_normal_stiffness(1e8);
  p.mutable_contacts()->set_friction(0.7);
  for (const char* name : {"floor", "platen"}) {
    auto& wall = *p.add_walls();
    wall.set_name(name);
    test::set(*wall.mutable_from(), 0, 0);
    test::set(*wall.mutable_to(), 2, 0);
  }
  p.mutable_walls(1)->mutable_contacts()->set_friction(0.1);
  p.mutable_walls(1)->mutable_velocity()->set_y(-0.5);
  const Model model = read_model(scene);
  ASSERT_EQ(model.walls.size(), 2u);
  EXPECT_EQ(model.walls[0].contact.friction, 0.7);
  EXPECT_EQ(model.walls[1].contact.friction, 0.1);
  EXPECT_EQ(model.walls[1].contact.normal_stiffness, 1e8);
  EXPECT_EQ(model.walls[1].vy, -0.5);
}

// VTP as text, and as results are written: the same discs to the bit.
TEST(ReadModel, ReadsVtpAsTextAndAsResultsAreWritten) {
  const std::string text =
      "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\"><PolyData>"
      "<Piece NumberOfPoints=\"2\"><PointData><DataArray type=\"Float64\" Name=\"radius_m\" "
      "format=\"ascii\">0.5 0.25"
      "</DataArray><DataArray type=\"Int32\" Name=\"group\" format=\"ascii\">4\n2</DataArray></PointData>"
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0.1 0  0.7 0.1 "
      "0</DataArray>"
      "</Points></Piece></PolyData></VTKFile>";
  const Model from_text = read_model(test::placed_scene(text));
  EXPECT_EQ(from_text.discs.x, (std::vector<double>{0, 0.7}));
  EXPECT_EQ(from_text.discs.radius, (std::vector<double>{0.5, 0.25}));

  wire::Piece piece;
  piece.set_name("particles");
  piece.set_shape(wire::Piece::VERTICES);
  for (const double value : {0.0, 0.1, 0.7, 0.1}) piece.add_points(value);
  const auto add = [&piece](const std::string& name, double first, double second) {
    auto& field = *piece.add_point_fields();
    field.set_name(name);
    field.set_components(1);
    field.add_values(first);
    field.add_values(second);
  };
  add("radius_m", 0.5, 0.25);
  add("group", 4, 2);
  const adit::test::ScratchFolder folder;
  results::write_piece(folder / "particles.vtp", piece);
  std::ifstream file(folder / "particles.vtp", std::ios::binary);
  auto scene = test::placed_scene({std::istreambuf_iterator<char>(file), {}});
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("small");
  group.set_number(2);
  const Model written = read_model(scene);
  EXPECT_EQ(written.discs.x, from_text.discs.x);
  EXPECT_EQ(written.discs.y, from_text.discs.y);
  EXPECT_EQ(written.discs.radius, from_text.discs.radius);
  EXPECT_EQ(written.group, (std::vector<std::uint32_t>{0, 1}));
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      three = three << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[three >> shift & 63];
  }
  for (std::size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
  return text;
}

// VTP holds whole numbers of every size, behind lengths of either size.
TEST(ReadModel, ReadsVtpOfEveryTypeOfNumbers) {
  const auto groups_as = [](const std::string& type, auto four, auto two) {
    for (const std::string header : {"UInt32", "UInt64"}) {
      std::uint64_t length = sizeof(four) + sizeof(two);
      std::string bytes(reinterpret_cast<const char*>(&length), header == "UInt32" ? 4 : 8);
      bytes.append(reinterpret_cast<const char*>(&four), sizeof(four));
      bytes.append(reinterpret_cast<const char*>(&two), sizeof(two));
      auto scene = test::placed_scene(
          "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"" +
          header +
          "\"><PolyData><Piece NumberOfPoints=\"2\"><PointData>"
          "<DataArray type=\"Float64\" Name=\"radius_m\" format=\"ascii\">0.5 0.25</DataArray>"
          "<DataArray type=\"" +
          type + "\" Name=\"group\" format=\"binary\">" + base64(bytes) +
          "</DataArray></PointData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
          "format=\"ascii\">0 0.1 0  0.7 0.1 0</DataArray></Points></Piece></PolyData></VTKFile>");
      auto& group = *scene.mutable_particles()->add_groups();
      group.set_name("small");
      group.set_number(2);
      EXPECT_EQ(read_model(scene).group, (std::vector<std::uint32_t>{0, 1})) << type << " " << header;
    }
  };
  groups_as("Float64", 4.0, 2.0);
  groups_as("Float32", 4.0F, 2.0F);
  groups_as("Int64", std::int64_t{4}, std::int64_t{2});
  groups_as("UInt64", std::uint64_t{4}, std::uint64_t{2});
  groups_as("Int32", std::int32_t{4}, std::int32_t{2});
  groups_as("UInt32", std::uint32_t{4}, std::uint32_t{2});
  groups_as("Int16", std::int16_t{4}, std::int16_t{2});
  groups_as("UInt16", std::uint16_t{4}, std::uint16_t{2});
  groups_as("Int8", std::int8_t{4}, std::int8_t{2});
  groups_as("UInt8", std::uint8_t{4}, std::uint8_t{2});
}

// One particle is a model; sizes of 1 to 50 are joined where they touch.
TEST(ReadModel, TakesOneParticleAndSizesOfOneToFifty) {
  const Model one = read_model(test::placed_scene("x_m,y_m,radius_m\n1,2,0.5\n"));
  EXPECT_EQ(one.discs.size(), 1u);
  EXPECT_TRUE(one.bonds.empty());
  const Model two = read_model(test::placed_scene("x_m,y_m,radius_m\n0,0,1\n1.02,0,0.02\n"));
  EXPECT_EQ(two.bonds.size(), 1u);
}

}  // namespace
}  // namespace adit::dem::read_model_test
