// Requirement: forces at rest carry the stated stress and balance on every disc, whatever is packed and
// joined; a lattice bears the forces of its closed form; what cannot be borne is cut and told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "dem_server/model/initial_state/faces.hpp"
#include "dem_server/model/initial_state/initial_state.hpp"
#include "dem_server/model/initial_state/outside.hpp"
#include "dem_server/model/reading/read_model.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/lattice_model.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::initial_state_test {
namespace {

// The uniform strain of a lattice under a stress loads a bond of direction n, t with kn 2R n.e.n and
// ks 2R t.e.n, the lattice being the solid of lambda + mu = sqrt(3)/2 kn, mu = sqrt(3)/4 (kn + ks).
TEST(InitialState, OfALatticeIsTheClosedForm) {
  const ContactBond law{7e6, 3e6};
  const double radius = 0.5, length = 2 * radius;
  Model model = test::lattice_in({0, 14, 0, 12}, radius, 2.0, law);
  const auto stated = [](double, double y) { return protocol::GroundStress{-3e3 + 40 * y, -5e3, 1e3, {}}; };
  set_initial_state(stated, model);
  const double kn = 7e6, ks = 3e6, bulk = std::numbers::sqrt3 / 2 * kn,
               shear = std::numbers::sqrt3 / 4 * (kn + ks);
  for (const Bond& bond : model.bonds) {
    const auto& [x, y, r] = model.discs;
    const double nx = (x[bond.second] - x[bond.first]) / length,
                 ny = (y[bond.second] - y[bond.first]) / length;
    const double cos_2 = nx * nx - ny * ny, sin_2 = 2 * nx * ny;
    const auto s = stated(0, (y[bond.first] + y[bond.second]) / 2);
    const double mean = (s.xx + s.yy) / 2 / bulk, deviator = (s.xx - s.yy) / 2 / shear, xy = s.xy / shear;
    EXPECT_NEAR(bond.at_rest.normal, kn * length * (mean + deviator * cos_2 + xy * sin_2) / 2, 1e-12 * 5e3);
    EXPECT_NEAR(bond.at_rest.shear, ks * length * (xy * cos_2 - deviator * sin_2) / 2, 1e-12 * 5e3);
  }
  EXPECT_TRUE(model.touching.empty());
}

// Requirement: the order in which discs are listed is no matter, also where the stated stress does not
// balance: the weight is lacking here, and nothing presses on two of the edges.
TEST(InitialState, IsThatOfDiscsInAnotherOrder) {
  const auto forces_of = [](bool reversed) {
    Model model = test::lattice_in({0, 9, 0, 8}, 0.5, 2.0, ContactBond{{7e6, 3e6}});
    const auto last = static_cast<std::uint32_t>(model.discs.size() - 1);
    if (reversed) {
      for (auto* values : {&model.discs.x, &model.discs.y}) std::ranges::reverse(*values);
      for (Bond& bond : model.bonds) {
        bond = {last - bond.second, last - bond.first, Bond::Law::kContactBond, 0};
        if (bond.first > bond.second) std::swap(bond.first, bond.second);
      }
    }
    set_initial_state(
        [](double x, double y) {
          return protocol::GroundStress{-3e3 - 300 * x, -5e3 + 90 * y, 0, {}};
        },
        model);
    std::map<std::pair<std::uint32_t, std::uint32_t>, PairForces> forces;
    for (const Bond& bond : model.bonds) {
      const std::uint32_t first = reversed ? last - bond.second : bond.first,
                          second = reversed ? last - bond.first : bond.second;
      forces[std::minmax({first, second})] = bond.at_rest;
    }
    return forces;
  };
  const auto listed = forces_of(false), reversed = forces_of(true);
  ASSERT_EQ(listed.size(), reversed.size());
  for (const auto& [pair, forces] : listed) {
    EXPECT_NEAR(forces.normal, reversed.at(pair).normal, 1e-9 * 5e3);
    EXPECT_NEAR(forces.shear, reversed.at(pair).shear, 1e-9 * 5e3);
  }
}

// Faces of a block of square packing: its cells, bordered by its outer discs.
TEST(InitialState, KnowsTheFacesBetweenDiscs) {
  auto scene = test::square_scene(5, 4);
  const Model model = read_model(scene);
  const Faces faces = find_faces(model.discs, links_of(model, {}));
  EXPECT_EQ(faces.inside.size(), 12u);
  for (const Face& face : faces.inside) EXPECT_NEAR(face.area, 1, 1e-12);
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    const double x = model.discs.x[i], y = model.discs.y[i];
    EXPECT_EQ(faces.border[i], x < 1 || x > 4 || y < 1 || y > 3);
  }
}

// Requirement: a force is shared by the discs that are there, and a spring to one that is not pulls nothing,
// as in the engines.
TEST(InitialState, NothingActsOnDiscsThatAreAbsent) {
  auto scene = test::square_scene(4, 1);
  auto& force = *scene.mutable_particles()->add_loads();
  force.mutable_where()->set_x_max(3);
  force.mutable_force()->set_y(-6e3);
  auto& spring = *scene.mutable_particles()->add_springs();
  test::set(*spring.mutable_from(), 1.5, 0.5);
  test::set(*spring.mutable_to(), 0.5, 0.5);
  spring.set_stiffness(1e6);
  spring.set_pretension(1e3);
  Model model = read_model(scene);
  model.present = {false, true, true, true};
  const auto forces = external_forces(model);
  for (std::size_t disc = 0; disc < 4; ++disc) {
    EXPECT_EQ(forces[3 * disc], 0) << disc;
    EXPECT_EQ(forces[3 * disc + 1], disc == 1 || disc == 2 ? -3e3 : 0) << disc;
  }
}

// The other model of an overlap holds each disc of a lattice by its area times s . grad w where the stress s
// is uniform and the weight w linear.
TEST(InitialState, IsHeldInAnOverlapByTheGradientOfTheWeights) {
  const double radius = 0.5, area = 2 * std::numbers::sqrt3 * radius * radius;
  const Model model = test::lattice_in({0, 9, 0, 8}, radius);
  const Faces faces = find_faces(model.discs, links_of(model, {}));
  std::vector<double> weights;
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    weights.push_back(0.1 + 0.05 * model.discs.x[i] + 0.03 * model.discs.y[i]);
  const auto forces = forces_of_overlap(model.discs, faces, weights, [](double, double) {
    return protocol::GroundStress{-3e3, -5e3, 1e3, {}};
  });
  std::size_t inside = 0;
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    EXPECT_EQ(forces[3 * i + 2], 0);
    if (faces.border[i]) continue;
    EXPECT_NEAR(forces[3 * i], -area * (-3e3 * 0.05 + 1e3 * 0.03), 1e-9);
    EXPECT_NEAR(forces[3 * i + 1], -area * (1e3 * 0.05 - 5e3 * 0.03), 1e-9);
    ++inside;
  }
  EXPECT_GT(inside, 20u);
}

// Resultants on the discs by what they bear at rest, contacts of parallel bonds included.
struct Resultants3 {
  std::vector<double> x, y, moment;
  double largest = 0;  // force of a link

  explicit Resultants3(const Model& model)
      : x(model.discs.size()), y(model.discs.size()), moment(model.discs.size()) {
    for (const Bond& b : model.bonds)
      add(model, b.first, b.second, b.nx, b.ny,
          {b.at_rest.normal + b.contact_normal, b.at_rest.shear + b.contact_shear, b.at_rest.moment});
    for (const TouchingPair& t : model.touching) add(model, t.first, t.second, 0, 0, {t.normal, t.shear, 0});
  }
  void add(const Model& model, std::uint32_t i, std::uint32_t j, double nx, double ny, const PairForces& f) {
    const Discs& d = model.discs;
    const double dx = d.x[j] - d.x[i], dy = d.y[j] - d.y[i], length = std::hypot(dx, dy);
    const double arm = (length + d.radius[i] - d.radius[j]) / 2;
    if (nx == 0 && ny == 0) nx = dx / length, ny = dy / length;
    const PlaneVector force = vector_of(nx, ny, f.normal, f.shear);
    const double turning = across(dx / length, dy / length, force.x, force.y);
    x[i] += force.x, y[i] += force.y, moment[i] += arm * turning + f.moment;
    x[j] -= force.x, y[j] -= force.y, moment[j] += (length - arm) * turning - f.moment;
    largest = std::max({largest, std::abs(f.normal), std::abs(f.shear)});
  }
};

// Random discs with a stiff group, bonds of every kind and a smooth joint, under their weight.
scene::Scene mixed(const std::string& bonds) {
  auto scene = test::random_scene();
  auto& p = *scene.mutable_particles();
  if (bonds == "parallel") {
    auto& parallel = *p.mutable_bonds()->mutable_parallel();
    parallel.set_normal_stiffness(2e11);
    parallel.set_shear_stiffness(1e11);
    p.mutable_contacts()->set_friction(0.5);
  }
  auto& group = *p.add_groups();
  group.set_name("stiff");
  group.mutable_where()->set_x_min(1.2);
  *group.mutable_material() = scene.material();
  group.mutable_material()->set_young_modulus(8e10);
  auto& joint = *p.add_joints();
  test::set(*joint.mutable_from(), 0.3, 0.1);
  test::set(*joint.mutable_to(), 1.0, 0.8);
  joint.mutable_smooth()->set_normal_stiffness(1e11);
  joint.mutable_smooth()->set_shear_stiffness(1e10);
  joint.mutable_smooth()->set_friction(5);
  p.add_body_loads()->mutable_acceleration()->set_y(-10);
  auto& stress = *scene.mutable_initial_stress();
  stress.set_xx(-2e6);
  stress.set_yy(-4e6);
  stress.set_xy(3e5);
  stress.set_yy_per_metre(2.5e4);
  protocol::check_rules(scene);
  return scene;
}

class InitialStateOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Bonds, InitialStateOf, testing::Values("contact", "parallel"),
                         [](const auto& info) { return info.param; });

TEST_P(InitialStateOf, RandomDiscsBalances) {
  const Model model = read_model(mixed(GetParam()));
  const Resultants3 sum(model);
  std::vector<Pair> touching;
  for (const TouchingPair& t : model.touching) touching.push_back({t.first, t.second});
  const auto links = links_of(model, touching);
  const Faces faces = find_faces(model.discs, links);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    if (faces.border[i]) continue;
    EXPECT_NEAR(sum.x[i], 0, 1e-6 * sum.largest) << i;
    EXPECT_NEAR(sum.y[i], 10 * model.mass[i], 1e-6 * sum.largest) << i;
    EXPECT_NEAR(sum.moment[i], 0, 1e-6 * sum.largest * model.discs.radius[i]) << i;
    ++inside;
  }
  EXPECT_GT(inside, model.discs.size() / 2);
}

// Bonds that are weaker than their part of the stress bear their strength, and the user is told.
// Bonds of Poisson's ratio 1/4 in plane strain resist no slip. They bear no shear force, also beside a group
// whose bonds do: a moment that excavation leaves on a disc could not come to rest.
TEST(InitialState, LeavesShearToBondsThatResistIt) {
  scene::Scene scene = test::empty_scene();
  scene.set_plane(scene::PLANE_STRAIN);
  scene.mutable_material()->set_poisson_ratio(0.25);
  auto& packing = *scene.mutable_particles()->mutable_packing();
  test::set_box(packing, 10, 8);
  packing.set_radius(0.5);
  auto& group = *scene.mutable_particles()->add_groups();
  group.set_name("gouge");
  group.mutable_where()->set_x_min(4);
  *group.mutable_material() = scene.material();
  group.mutable_material()->set_poisson_ratio(0.1);
  scene.mutable_initial_stress()->set_xx(-2e6);
  scene.mutable_initial_stress()->set_yy(-4e6);
  const Model model = read_model(scene);
  double gouge = 0;
  for (const Bond& bond : model.bonds) {
    const auto [left, right] = std::minmax(model.discs.x[bond.first], model.discs.x[bond.second]);
    if (right < 4)
      EXPECT_EQ(bond.at_rest.shear, 0);
    else if (left >= 4)
      gouge = std::max(gouge, std::abs(bond.at_rest.shear));
  }
  EXPECT_GT(gouge, 1e3);
}

TEST(InitialState, CutsWhatIsBeyondStrength) {
  auto scene = test::random_scene();
  scene.mutable_particles()->mutable_bonds()->set_tensile_strength(2e3);
  scene.mutable_initial_stress()->set_yy(1e5);
  protocol::check_rules(scene);
  const Model model = read_model(scene);
  double most = 0;
  for (const Bond& bond : model.bonds) most = std::max(most, bond.at_rest.normal);
  EXPECT_DOUBLE_EQ(most, 2e3);
  EXPECT_THAT(model.notes, testing::Contains(testing::HasSubstr("cannot bear their part")));
}

// A wall starts free of force: one that particles touch is refused, one away from them is not.
TEST(InitialState, IsNotBorneByWalls) {
  auto scene = test::square_scene(6, 4);
  scene.mutable_initial_stress()->set_yy(-1e5);
  auto& wall = *scene.mutable_particles()->add_walls();
  wall.set_name("floor");
  test::set(*wall.mutable_from(), -1, 0);
  test::set(*wall.mutable_to(), 7, 0);
  adit::test::expect_refusal([&] { read_model(scene); }, "particles.walls[0]",
                             "a wall cannot bear its part of initial_stress");
  wall.mutable_from()->set_y(-0.1);
  wall.mutable_to()->set_y(-0.1);
  EXPECT_EQ(read_model(scene).walls.size(), 1u);
  test::set(*wall.mutable_from(), 4, 0);  // below one particle alone
  test::set(*wall.mutable_to(), 5, 0);
  adit::test::expect_refusal([&] { read_model(scene); }, "particles.walls[0]",
                             "touches the particle at (4.5, 0.5) m");
}

}  // namespace
}  // namespace adit::dem::initial_state_test
