// Requirements on the motions of joints: those of rigid bodies, whatever a few grains do, and what a bolt
// allows.
#include "dem_server/lining/joint_faces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "dem_server/engines/general/general_engine.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/fragments.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/discs_models.hpp"
#include "tests/unit/dem_server/in_process_run.hpp"
#include "tests/unit/dem_server/scenes_of_discs.hpp"

namespace adit::dem::joint_faces_test {
namespace {

constexpr int kRows = 6;

// Two blocks of cemented discs side by side, apart from each other at x = 3.
Model two_blocks(Bond::Law law = Bond::Law::kParallelBond) {
  std::vector<std::array<double, 3>> discs;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < 6; ++column) discs.push_back({column + 0.5, row + 0.5, 0.5});
  Model model = test::loose_discs(discs, {1e8, 1e8, 0});
  model.parallel_bonds = {{1e9, 1e9, 0.4, 1e12, 1e12, 0}};
  model.contact_bonds = {{.stiffness = {1e8, 1e8}}};
  test::join(model, law);
  std::erase_if(model.bonds, [&](const Bond& bond) {
    return (model.discs.x[bond.first] < 3) != (model.discs.x[bond.second] < 3);
  });
  return model;
}

// Upwards: the far face lies on the left, at smaller x.
JointFaces joint(const Particles& p) {
  return {"joint", {3, 0}, {3, kRows}, p, pairs_within({p.x, p.y, p.radius}, 0.1)};
}

// The left block moves away by 3 mm, up by 2 mm and turns by 1 mrad about the middle of the joint while both
// move and turn together.
void move_blocks(Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool far = p.x[i] < 3;
    const double rotation = 5e-3 + (far ? 1e-3 : 0);
    p.ux[i] = 0.7 - (far ? 3e-3 : 0) - rotation * (p.y[i] - 3);
    p.uy[i] = -0.4 + (far ? 2e-3 : 0) + rotation * (p.x[i] - 3);
  }
}

void expect_motion(const JointMotion& motion) {
  EXPECT_NEAR(motion.opening, 3e-3, 1e-12);
  EXPECT_NEAR(motion.offset, 2e-3, 1e-12);
  EXPECT_NEAR(motion.rotation, 1e-3, 1e-12);
}

JointMotion motion_of(const JointFaces& faces, const GeneralEngine& engine) {
  const Fragments fragments = fragments_of(engine.particles().size(), firm_bonds(engine));
  return faces.motion(engine.particles(), {fragments.number, fragments.size});
}

TEST(JointFaces, TellTheRelativeMotionOfRigidBodies) {
  GeneralEngine engine(two_blocks(), 1);
  Particles& p = engine.particles();
  const JointFaces faces = joint(p);
  EXPECT_EQ(faces.near_face().size(), std::size_t{kRows});
  EXPECT_EQ(faces.far_face().size(), std::size_t{kRows});
  move_blocks(p);
  expect_motion(motion_of(faces, engine));
}

// Two grains that are lost, one of either face, change nothing; displacements count from when time began.
TEST(JointFaces, DoNotFollowGrainsThatFellOff) {
  Model model = two_blocks();
  const auto lost = [&](std::uint32_t disc) {
    return std::abs(model.discs.x[disc] - 3) < 1 &&
           (model.discs.y[disc] == 0.5 || model.discs.y[disc] == 2.5);
  };
  std::erase_if(model.bonds, [&](const Bond& bond) { return lost(bond.first) || lost(bond.second); });
  GeneralEngine engine(model, 1);
  Particles& p = engine.particles();
  const JointFaces faces = joint(p);
  EXPECT_EQ(faces.far_face().size(), std::size_t{kRows});
  move_blocks(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::abs(p.x[i] - 3) < 1 && (p.y[i] == 0.5 || p.y[i] == 2.5)) p.uy[i] -= 5;
    p.settled_x[i] = 0.01;
    p.ux[i] += 0.01;
  }
  expect_motion(motion_of(faces, engine));
}

// Cuts the bonds between what lies in the area and the rest.
template <class Area>
void cut_out(const Area& area, Model& model) {
  const auto inside = [&](std::uint32_t i) { return area(model.discs.x[i], model.discs.y[i]); };
  std::erase_if(model.bonds, [&](const Bond& bond) { return inside(bond.first) != inside(bond.second); });
}

// A corner that breaks off with more than half of a face changes nothing either.
TEST(JointFaces, DoNotFollowACornerThatFellOff) {
  Model model = two_blocks();
  const auto in_corner = [](double x, double y) { return x > 3 && x < 4 && y < 4; };
  cut_out(in_corner, model);
  GeneralEngine engine(model, 1);
  Particles& p = engine.particles();
  const JointFaces faces = joint(p);
  move_blocks(p);
  std::size_t fallen = 0;
  for (const std::uint32_t i : faces.near_face())
    if (in_corner(p.x[i], p.y[i])) {
      p.uy[i] -= 5;
      ++fallen;
    }
  EXPECT_EQ(fallen, 4u);
  expect_motion(motion_of(faces, engine));
}

// A grain that hangs on its body by one bond without moment rolls on it; one whose bond bears moments does
// not.
TEST(JointFaces, DoNotFollowAGrainThatRollsOnOneBond) {
  for (const Bond::Law law : {Bond::Law::kContactBond, Bond::Law::kParallelBond}) {
    Model model = two_blocks(law);
    // The lowest disc of the near face keeps the bond to the right alone.
    std::erase_if(model.bonds, [&](const Bond& bond) {
      const auto lowest = [&](std::uint32_t i) { return model.discs.x[i] == 3.5 && model.discs.y[i] == 0.5; };
      const auto beside = [&](std::uint32_t i) { return model.discs.x[i] == 4.5 && model.discs.y[i] == 0.5; };
      const bool kept = beside(bond.first) || beside(bond.second);
      return (lowest(bond.first) || lowest(bond.second)) && !kept;
    });
    GeneralEngine engine(model, 1);
    Particles& p = engine.particles();
    const JointFaces faces = joint(p);
    move_blocks(p);
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p.x[i] == 3.5 && p.y[i] == 0.5) p.ux[i] -= 0.5;
    if (law == Bond::Law::kContactBond)
      expect_motion(motion_of(faces, engine));
    else
      EXPECT_GT(std::abs(motion_of(faces, engine).opening), 0.05);
  }
}

// A grain at the end of the joint that belongs to larger ground does not decide either.
TEST(JointFaces, DoNotFollowTheGroundBesideThem) {
  Model model = two_blocks();
  const auto outermost = [](double x, double y) { return x > 3 && x < 4 && y < 1; };
  cut_out(outermost, model);
  GeneralEngine engine(model, 1);
  Particles& p = engine.particles();
  const JointFaces faces = joint(p);
  move_blocks(p);
  Fragments fragments = fragments_of(p.size(), whole_bonds(engine));
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (outermost(p.x[i], p.y[i])) {
      p.uy[i] -= 5;
      fragments.size[fragments.number[i]] = 1000;
    }
  expect_motion(faces.motion(p, {fragments.number, fragments.size}));
}

TEST(JointFaces, TellNothingOfAFaceThatFellApart) {
  Model model = two_blocks();
  std::erase_if(model.bonds, [&](const Bond& bond) { return model.discs.x[bond.first] > 3; });
  GeneralEngine engine(model, 1);
  const Particles& p = engine.particles();
  EXPECT_TRUE(std::isnan(motion_of(joint(p), engine).opening));
}

constexpr double kStiffness = 1e6, kPull = 2e3, kArm = 2.0;

// Two stiff blocks, held together by two bolts at y = 3 -+ arm, under a pull and a moment on the right one.
scene::Scene bolted() {
  auto scene = test::square_scene(6, kRows);
  auto& particles = *scene.mutable_particles();
  auto& cement = *particles.mutable_bonds()->mutable_parallel();
  cement.set_normal_stiffness(5e9);
  cement.set_shear_stiffness(5e9);
  auto& joint = *particles.add_joints();
  joint.set_name("joint");
  joint.set_open(true);
  test::set(*joint.mutable_from(), 3, kRows);  // downwards: the far face lies at larger x
  test::set(*joint.mutable_to(), 3, 0);
  for (const double y : {3 - kArm - 0.5, 3 + kArm + 0.5}) {
    auto& bolt = *particles.add_springs();
    bolt.set_name(y < 3 ? "lower" : "upper");
    test::set(*bolt.mutable_from(), 2.5, y);
    test::set(*bolt.mutable_to(), 3.5, y);
    bolt.set_stiffness(kStiffness);
  }
  auto& clamp = *particles.add_motions();
  clamp.mutable_where()->set_x_max(1);
  clamp.mutable_velocity()->set_x(0);
  clamp.mutable_velocity()->set_y(0);
  clamp.set_spin(0);
  for (const double y : {0.5, kRows - 0.5}) {  // 3/4 of the pull below, 1/4 above
    auto& load = *particles.add_loads();
    load.mutable_where()->set_x_min(5);
    load.mutable_where()->set_y_min(y - 0.5);
    load.mutable_where()->set_y_max(y + 0.5);
    load.mutable_force()->set_x(y < 3 ? 0.75 * kPull : 0.25 * kPull);
  }
  particles.mutable_damping()->set_local(0.7);
  const auto add = [&](const std::string& name, scene::Quantity quantity) -> scene::History& {
    auto& history = *particles.add_histories();
    history.set_name(name);
    history.set_quantity(quantity);
    return history;
  };
  for (const auto quantity : {scene::OPENING, scene::OFFSET, scene::ROTATION})
    add("joint", quantity).set_joint("joint");
  for (const char* bolt : {"lower", "upper"}) add(bolt, scene::SPRING_FORCE).set_spring(bolt);
  return scene;
}

// The bolts share the pull F and its moment F h / 2 about the middle (h the distance of the two loads from
// it): N = F/2 -+ M / (2 arm); the joint opens by the bolts' mean lengthening and turns by its difference
// over 2 arm.
TEST(JointFaces, OpenAsTheirBoltsStretch) {
  test::InProcessRun run(bolted(), {}, 0.8);
  for (int n = 0; n < 60000; ++n) run.advance();
  const auto& values = run.predicted.histories();
  const double arm = kArm + 0.5, moment = kPull / 2 * arm;
  const double lower = kPull / 2 + moment / (2 * arm), upper = kPull / 2 - moment / (2 * arm);
  EXPECT_NEAR(values[3], lower, 1e-3 * lower);
  EXPECT_NEAR(values[4], upper, 3e-3 * upper);
  const double opening = (lower + upper) / 2 / kStiffness,
               rotation = (lower - upper) / kStiffness / (2 * arm);
  EXPECT_NEAR(values[0], opening, 0.02 * opening);
  EXPECT_NEAR(values[2], rotation, 0.02 * rotation) << "wider below: counter-clockwise";
}

// Joints that slide show how far, with their largest slip so far.
TEST(JointFaces, SmoothJointsHaveFieldsOfSlip) {
  auto scene = test::square_scene(4, 4);
  auto& particles = *scene.mutable_particles();
  particles.mutable_bonds();
  auto& joint = *particles.add_joints();
  test::set(*joint.mutable_from(), 0, 2);
  test::set(*joint.mutable_to(), 4, 2);
  joint.mutable_smooth()->set_normal_stiffness(1e9);
  joint.mutable_smooth()->set_shear_stiffness(1e9);
  auto& motion = *particles.add_motions();
  motion.mutable_where()->set_y_min(2);
  motion.mutable_velocity()->set_x(0.3);
  motion.mutable_velocity()->set_y(0);
  motion.set_spin(0);
  auto& held = *particles.add_motions();
  held.mutable_where()->set_y_max(2);
  held.mutable_velocity()->set_x(0);
  held.mutable_velocity()->set_y(0);
  held.set_spin(0);
  test::InProcessRun run(scene);
  for (int n = 0; n < 100; ++n) run.advance();
  wire::Snapshot snapshot;
  run.participant.snapshot({}, snapshot);
  const auto& piece = snapshot.pieces(snapshot.pieces_size() - 1);
  ASSERT_EQ(piece.name(), "joints");
  ASSERT_EQ(piece.connectivity_size(), 8);
  ASSERT_EQ(piece.cell_fields_size(), 6);
  EXPECT_EQ(piece.cell_fields(2).name(), "slip_m");
  EXPECT_EQ(piece.cell_fields(4).name(), "peak_slip_m");
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::abs(piece.cell_fields(2).values(k)), 0.3 * 99 * run.dt, 1e-9);
    EXPECT_NEAR(piece.cell_fields(4).values(k), 0.3 * 99 * run.dt, 1e-9);
    EXPECT_NEAR(piece.cell_fields(3).values(k), 0, 1e-12);
  }
}

using Case = adit::test::Refusal<std::function<void(scene::Particles&)>>;
class JointErrors : public testing::TestWithParam<Case> {};

TEST_P(JointErrors, NameTheFieldAndTheRemedy) {
  auto scene = bolted();
  GetParam().input(*scene.mutable_particles());
  adit::test::expect_refusal([&] { test::InProcessRun run(scene); }, "particles." + GetParam().path,
                             GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, JointErrors,
    testing::Values(Case{"Twice", "joints[1].name", "is `joint`, like that of an earlier joint",
                         [](auto& s) {
                           auto& joint = *s.add_joints();
                           joint = s.joints(0);
                           test::set(*joint.mutable_from(), 2, kRows);
                           test::set(*joint.mutable_to(), 2, 0);
                         }},
                    Case{"OnePairOnly", "joints[1]", "has fewer than two particles on a face of `short`",
                         [](auto& s) {
                           auto& joint = *s.add_joints();
                           joint.set_name("short");
                           joint.set_open(true);
                           test::set(*joint.mutable_from(), 2, 0);
                           test::set(*joint.mutable_to(), 2, 1);
                         }},
                    Case{"NoSuchJoint", "histories[0].joint",
                         "is `crown`, but opening is a motion of a joint; choose one of joint",
                         [](auto& s) { s.mutable_histories(0)->set_joint("crown"); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::joint_faces_test
