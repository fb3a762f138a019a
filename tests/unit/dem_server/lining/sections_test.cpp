// Requirements on sections: their forces balance the loads and the inertia of what lies beyond them.
#include "dem_server/lining/sections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <random>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/engines/lattice/lattice_engine.hpp"
#include "dem_server/lining/envelope.hpp"
#include "dem_server/lining/median.hpp"
#include "dem_server/lining/read_lining.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/packing/regular.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::sections_test {
namespace {

constexpr double kFx = 3e5, kFy = -2e5;
constexpr int kColumns = 12, kRows = 3;
constexpr double kPlaces[] = {2, 5, 10};

scene::ParticleSection& add_section(scene::Particles& particles, const std::string& name, double x) {
  auto& section = *particles.add_sections();
  section.set_name(name);
  test::set(*section.mutable_from(), x, -0.5);
  test::set(*section.mutable_to(), x, kRows + 0.5);
  return section;
}

// A strip of cemented discs, clamped on its left, pulled down and outwards at its right end; with strong
// damping it comes to rest.
scene::Scene cantilever() {
  auto scene = test::square_scene(kColumns, kRows);
  auto& particles = *scene.mutable_particles();
  auto& cement = *particles.mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(2e9);
  cement.set_shear_stiffness(1e9);
  auto& clamp = *particles.add_motions();
  clamp.mutable_where()->set_x_max(1);
  clamp.mutable_velocity()->set_x(0);
  clamp.mutable_velocity()->set_y(0);
  clamp.set_spin(0);
  auto& load = *particles.add_loads();
  load.mutable_where()->set_x_min(kColumns - 1);
  load.mutable_force()->set_x(kFx);
  load.mutable_force()->set_y(kFy);
  particles.mutable_damping()->set_local(0.7);
  for (const double x : kPlaces) {
    const std::string name = "at_" + std::to_string(static_cast<int>(x));
    add_section(particles, name, x);
    for (const auto quantity : {scene::THRUST, scene::MOMENT, scene::SHEAR_FORCE}) {
      auto& history = *particles.add_histories();
      history.set_name(name);
      history.set_section(name);
      history.set_quantity(quantity);
    }
  }
  return scene;
}

const wire::Piece& piece(const wire::Snapshot& snapshot, const std::string& name) {
  for (const auto& piece : snapshot.pieces())
    if (piece.name() == name) return piece;
  throw std::runtime_error("no piece " + name);
}

const wire::Field& field(const wire::Piece& piece, const std::string& name) {
  for (const auto& field : piece.point_fields())
    if (field.name() == name) return field;
  throw std::runtime_error("no field " + name);
}

// At rest thrust, shear force and moment of every section are those of the tip's load, which acts where the
// particles have moved to; the field at the sections' places shows them too.
TEST(Sections, BalanceTheLoadOfACantilever) {
  test::InProcessRun run(cantilever(), {}, 0.8);
  for (int n = 0; n < 40000; ++n) run.advance();
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& particles = piece(snapshot, "particles");
  const auto& sections = piece(snapshot, "sections");
  const auto& moved = field(particles, "displacement_m").values();
  const auto& values = run.predicted.histories();
  ASSERT_EQ(values.size(), 9);
  ASSERT_EQ(sections.connectivity_size(), 3);
  for (int k = 0; k < 3; ++k) {
    const double x = sections.points(2 * k) + field(sections, "displacement_m").values(3 * k);
    const double y = sections.points(2 * k + 1) + field(sections, "displacement_m").values(3 * k + 1);
    double turning = 0;
    for (int i = 0; i < particles.points_size() / 2; ++i) {
      if (particles.points(2 * i) < kColumns - 1) continue;
      const double px = particles.points(2 * i) + moved[3 * i],
                   py = particles.points(2 * i + 1) + moved[3 * i + 1];
      turning += ((px - x) * kFy - (py - y) * kFx) / kRows;
    }
    EXPECT_NEAR(values[3 * k], kFx, 1e-10 * kFx);
    EXPECT_NEAR(values[3 * k + 1], -turning, 1e-10 * std::abs(turning));
    EXPECT_GT(values[3 * k + 1], 0) << "a load downwards stretches the upper side";
    EXPECT_NEAR(values[3 * k + 2], kFy, 1e-10 * std::abs(kFy));
    EXPECT_EQ(field(sections, "thrust_N").values(k), values[3 * k]);
    EXPECT_EQ(field(sections, "moment_Nm").values(k), values[3 * k + 1]);
    EXPECT_EQ(field(sections, "shear_N").values(k), values[3 * k + 2]);
  }
}

// The engine's own Newton's law, summed over what lies left of a section of a model without loads: the forces
// of its section are the rate of its momentum, and their moment that of its angular momentum.
void expect_newtons_law(LocalEngine& engine, const Cut& cut, double dt, int steps) {
  Particles& p = engine.particles();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> speed(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = speed(random);
    p.vy[i] = speed(random);
    p.spin[i] = speed(random) / p.radius[i];
  }
  const Sections sections({cut}, p, all_bonds(engine));
  double largest = 0;
  for (int n = 1; n <= steps; ++n) {
    const Particles before = p;
    engine.step_interface({static_cast<std::uint64_t>(n), dt});
    engine.step_interior({static_cast<std::uint64_t>(n), dt});
    const SectionForces forces = section_forces(engine, sections)[0];
    const auto [ux, uy] = sections.displacement(0, p);
    const auto [x, y] = sections.middle(0);
    double fx = 0, fy = 0, turning = 0, all = 0, turned = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double beyond = p.x[i] - cut.from.x;
      if (beyond > 1e-9) continue;
      const double share = beyond < -1e-9 ? 1 : 0.5;  // of a particle on the cut a half
      const double ax = share * p.mass[i] * (p.vx[i] - before.vx[i]) / dt,
                   ay = share * p.mass[i] * (p.vy[i] - before.vy[i]) / dt;
      const double arm_x = p.x[i] + p.ux[i] - x - ux, arm_y = p.y[i] + p.uy[i] - y - uy;
      fx += ax;
      fy += ay;
      turning += arm_x * ay - arm_y * ax + share * p.inertia[i] * (p.spin[i] - before.spin[i]) / dt;
      all += std::hypot(ax, ay);
      turned += std::hypot(ax, ay) * std::hypot(arm_x, arm_y);
    }
    EXPECT_NEAR(forces.thrust, fx, 1e-11 * all) << n;
    EXPECT_NEAR(forces.shear, fy, 1e-11 * all) << n;
    EXPECT_NEAR(forces.moment, -turning, 1e-11 * turned) << n;
    largest = std::max(largest, std::abs(forces.thrust));
  }
  EXPECT_GT(largest, 0);
}

Model strip(Bond::Law law) {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column)
      discs.push_back({0.2 * column + 0.1 * (row % 2), 0.1 * std::numbers::sqrt3 * row, 0.1});
  Model model = test::loose_discs(discs, {1e8, 5e7, 0.4});
  model.contact_bonds = {{1e8, 4e7, 2e4, 2e4}};
  model.parallel_bonds = {{2e9, 1e9, 0.08, 3e5, 3e5, 0.3}};
  model.smooth_joints = {{1e9, 1e9, 0.3, 0, 0.2}};
  test::join(model, law);
  return model;
}

const Cut kCut{"middle", {0.75, -1}, {0.75, 2}};

TEST(Sections, CarryTheInertiaOfBondsThatBreakJointsAndSprings) {
  Model model = strip(Bond::Law::kParallelBond);
  int joints = 0;
  for (Bond& bond : model.bonds) {
    const bool first_left = model.discs.x[bond.first] < kCut.from.x,
               second_left = model.discs.x[bond.second] < kCut.from.x;
    if (first_left != second_left && joints++ < 2)
      bond = {bond.first, bond.second, Bond::Law::kSmoothJoint, 0, first_left ? 1.0 : -1.0, 0};
  }
  ASSERT_GT(joints, 2) << "other bonds cross the cut, too";
  model.springs = {{0, 7, 1e7, false, 1e3, 1e9}};
  const double dt = 0.2 * critical_step(model);
  GeneralEngine engine(model, 1);
  expect_newtons_law(engine, kCut, dt, 200);
  std::size_t broken = 0;
  engine.for_each_bond([&](const ObservedPair& bond) { broken += bond.state != BondState::kIntact; });
  EXPECT_GT(broken, 5u) << "the test would not see contacts that bonds leave";
}

TEST(Sections, CarryTheInertiaOfALattice) {
  Model model = strip(Bond::Law::kContactBond);
  model.contacts = {{1e8, 0, 0}};
  const double dt = 0.2 * critical_step(model);
  for (const double x : {0.75, 0.8}) {  // between particles, and through those of every second row
    LatticeEngine engine(model, 1);
    expect_newtons_law(engine, {"middle", {x, -1}, {x, 2}}, dt, 200);
  }
}

// The middle of a section goes with its particles, and a grain that is lost does not take it along.
TEST(Sections, FollowTheParticlesButNotALooseGrain) {
  Model model = strip(Bond::Law::kParallelBond);
  GeneralEngine engine(model, 1);
  Particles& p = engine.particles();
  const Sections sections({kCut}, p, all_bonds(engine));
  for (std::size_t i = 0; i < p.size(); ++i) p.ux[i] = 0.3;
  p.ux[sections.beside(0)[0]] = 0.3 + 100;
  EXPECT_EQ(sections.displacement(0, p).x, 0.3);
  EXPECT_EQ(median({3, 1, 100, 2}), 2.5);
}

// Each extreme comes with the time at which it was reached first.
// Grains from both sides that meet elsewhere are no part of what the section bears.
TEST(Sections, LeaveOutWhatFallsFarAway) {
  GeneralEngine engine(strip(Bond::Law::kParallelBond), 1);
  const Sections sections({kCut}, engine.particles(), all_bonds(engine));
  const Particles& p = engine.particles();  // which the engine numbers as it likes
  const auto nearest = [&p](double x) {
    const auto found = std::ranges::min_element(p.x, {}, [x](double place) { return std::abs(place - x); });
    return static_cast<std::uint32_t>(found - p.x.begin());
  };
  const auto thrust_at = [&](double y) {
    const std::vector<PairForce> pairs{{nearest(0.6), nearest(0.8), 0.75, y, 1e3, 0, 0}};
    return sections.forces(p, pairs)[0].thrust;
  };
  EXPECT_EQ(std::abs(thrust_at(0.3)), 1e3);
  EXPECT_EQ(thrust_at(4.0), 0);
}

TEST(Sections, EnvelopeKeepsTheExtremes) {
  Envelope envelope;
  EXPECT_TRUE(envelope.largest(Force::kThrust).empty());
  envelope.take(std::vector<SectionForces>{{1, -2, 0}, {5, 0, 0}}, 0.1);
  envelope.take(std::vector<SectionForces>{{3, -7, 0}, {-5, 0, 0}}, 0.2);
  envelope.take(std::vector<SectionForces>{{3, 4, 0}, {0, 0, 0}}, 0.3);
  EXPECT_EQ(envelope.largest(Force::kThrust)[0].value, 3);
  EXPECT_EQ(envelope.largest(Force::kThrust)[0].time, 0.2);
  EXPECT_EQ(envelope.smallest(Force::kThrust)[1].value, -5);
  EXPECT_EQ(envelope.smallest(Force::kMoment)[0].value, -7);
  EXPECT_EQ(envelope.largest(Force::kMoment)[0].time, 0.3);
  EXPECT_EQ(envelope.largest(Force::kShear)[1].time, 0.1);

  state::Archive writes;
  envelope.exchange(2, writes);
  state::Archive reads(writes.take());
  Envelope back;
  back.exchange(2, reads);
  for (const Force force : {Force::kThrust, Force::kMoment, Force::kShear})
    for (std::size_t section = 0; section < 2; ++section) {
      EXPECT_EQ(back.largest(force)[section].value, envelope.largest(force)[section].value);
      EXPECT_EQ(back.largest(force)[section].time, envelope.largest(force)[section].time);
      EXPECT_EQ(back.smallest(force)[section].value, envelope.smallest(force)[section].value);
      EXPECT_EQ(back.smallest(force)[section].time, envelope.smallest(force)[section].time);
    }
}

// The end of a run tells the extremes over all sections: under a load that only grows, those of the last step
// in the section next to the clamp.
TEST(Sections, EndWithTheExtremesOfAll) {
  test::InProcessRun run(cantilever(), {}, 0.8);
  for (int n = 0; n < 4000; ++n) run.advance();
  wire::Bye bye;
  run.participant.finish(bye);
  std::map<std::string, double> figures;
  for (const auto& figure : bye.figures()) figures[figure.name()] = figure.value();
  ASSERT_EQ(figures.size(), 24u);
  EXPECT_EQ(figures["sections_largest_moment_x_m"], kPlaces[0]);
  EXPECT_EQ(figures["sections_largest_moment_y_m"], kRows / 2.0);
  EXPECT_GE(figures["sections_largest_moment_Nm"], run.predicted.histories(1));
  EXPECT_LE(figures["sections_smallest_shear_N"], kFy);
  EXPECT_GT(figures["sections_largest_thrust_time_s"], 0);
}

using Case = adit::test::Refusal<std::function<void(scene::Particles&)>>;
class SectionErrors : public testing::TestWithParam<Case> {};

TEST_P(SectionErrors, NameTheFieldAndTheRemedy) {
  auto scene = cantilever();
  GetParam().input(*scene.mutable_particles());
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, "particles." + GetParam().path,
                             GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, SectionErrors,
    testing::Values(Case{"Twice", "sections[3].name", "is `at_5`, like that of an earlier section",
                         [](auto& s) { add_section(s, "at_5", 3); }},
                    Case{"Point", "sections[3].to", "is the same place as `from`",
                         [](auto& s) {
                           auto& section = add_section(s, "point", 3);
                           *section.mutable_to() = section.from();
                         }},
                    Case{"Outside", "sections[3]", "crosses no bond between particles",
                         [](auto& s) { add_section(s, "outside", 40); }},
                    Case{"OnAJoint", "sections[3]",
                         "crosses no bond, because it lies on particles.joints[0] (`joint`); lay it beside",
                         [](auto& s) {
                           const auto& section = add_section(s, "seam", 7);
                           auto& joint = *s.add_joints();
                           *joint.mutable_from() = section.from();
                           *joint.mutable_to() = section.to();
                           joint.set_name("joint");
                           joint.set_open(true);
                         }},
                    Case{"OnAJointOfTheRing", "sections[3]",
                         "crosses no bond, because it lies on a joint of particles.ring; lay it beside",
                         [](auto& s) {
                           add_section(s, "seam", 7);
                           auto& ring = *s.mutable_ring();
                           test::set(*ring.mutable_centre(), 7, kRows / 2.0);
                           ring.set_inner_radius(0.1);
                           ring.set_outer_radius(20);
                           ring.set_segments(2);
                           ring.set_first_joint(std::numbers::pi / 2);
                         }},
                    Case{"BetweenLooseParticles", "sections[0]", "crosses no bond between particles; lay it",
                         [](auto& s) {
                           s.clear_bonds();
                           s.mutable_contacts();
                         }},
                    Case{"NoSuchSection", "histories[0].section", "choose one of at_2, at_5, at_10",
                         [](auto& s) { s.mutable_histories(0)->set_section("crown"); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::sections_test
