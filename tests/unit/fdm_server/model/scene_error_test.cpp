// Every error of the scene that this server finds: the field's path and a sentence that says what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::scene_error_test {
namespace {

using testing::HasSubstr;

struct Case {
  std::string name, conditions, path, message;
  std::string block = kBlock, material = kMaterial;
};

const std::string kStatics = " statics {} ";

class SceneError : public testing::TestWithParam<Case> {};

TEST_P(SceneError, NamesTheFieldAndTheRemedy) {
  const Case& refused = GetParam();
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  adit::test::expect_refusal(
      [&] {
        set_up(participant, setup_of(refused.conditions, refused.block, refused.material), model);
        participant.weigh({}, interface);
      },
      refused.path, refused.message);
}

std::string block(const std::string& x_min, const std::string& x_max, const std::string& y_max,
                  const std::string& zones) {
  return "block { x_min: " + x_min + " x_max: " + x_max + " y_min: 0 y_max: " + y_max + " " + zones + " }";
}
std::string material(const std::string& e, const std::string& nu, const std::string& rho) {
  return "material { young_modulus: " + e + " poisson_ratio: " + nu + " density: " + rho + " } ";
}
const std::string kLining =
    "linings { name: 'top' along { line { points { x: 0 y: 1 } points { x: 6 y: 1 } } } thickness: 0.5 "
    "young_modulus: 30e9 } ";
const std::string kSegments =
    kLining.substr(0, kLining.size() - 2) + "joints { at { x: 3 y: 1 } contact { height: 0.4 } } } ";
// A reinforced wall; `more` belongs to its section.
std::string reinforced(const std::string& name, const std::string& y, const std::string& more) {
  return "linings { name: '" + name + "' along { line { points { x: 0 y: " + y + " } points { x: 6 y: " + y +
         " } } } section { thickness: 0.4 cover: 0.04 concrete { class: 'C30/37' } steel { class: 'B500B' } "
         "inner { diameter: "
         "0.02 spacing: 0.2 } outer { diameter: 0.02 spacing: 0.2 } " +
         more + " } } ";
}
const std::string kZones = "zones_x: 4 zones_y: 2", kNowhere = "where { x_min: 7 } ";

INSTANTIATE_TEST_SUITE_P(
    Scenes, SceneError,
    testing::Values(
        Case{"mixed_values", reinforced("top", "1", "") + reinforced("bottom", "0", "values: DESIGN"),
             "continuum.linings[1].section.values",
             "is design, but continuum.linings[0].section.values is mean; state the same for all"},
        Case{"empty_width", "", "continuum.block.x_max", "is 1 m, expected a length above `x_min` = 2 m",
             block("2", "1", "1", kZones)},
        Case{"empty_height", "", "continuum.block.y_max", "is 0 m, expected a length above `y_min` = 0 m",
             block("0", "1", "0", kZones)},
        Case{"infinite_block", "", "continuum.block.x_max", "is infinite, expected a length",
             block("0", "inf", "1", kZones)},
        Case{"no_zones", "", "continuum.block.zones_y", "is 0, expected a whole number above 0",
             block("0", "1", "1", "zones_x: 4 zones_y: 0")},
        Case{"too_many_zones", "", "continuum.block", "use larger zones",
             block("0", "1", "1", "zones_x: 4000000000 zones_y: 4000000000")},
        Case{"young", "", "material.young_modulus", "is 0 Pa, expected a pressure above 0 Pa", kBlock,
             material("0", "0.2", "2500")},
        Case{"poisson", "", "material.poisson_ratio", "expected a pure number above -1 and below 0.5", kBlock,
             material("1e9", "0.5", "2500")},
        Case{"density", "", "material.density", "expected a density above 0 kg/m^3", kBlock,
             material("1e9", "0.2", "-1")},
        Case{"own_young", "material { young_modulus: -1 poisson_ratio: 0.2 density: 2500 }",
             "continuum.material.young_modulus", "is -1 Pa, expected a pressure above 0 Pa"},
        Case{"no_material", "", "material", "is missing; give it, or continuum.material", kBlock, ""},
        Case{"point_load_nowhere", "point_loads { " + kNowhere + "force { x: 1 } }",
             "continuum.point_loads[0].where", "selects no grid points"},
        Case{"edge_load_nowhere",
             "edge_loads { where { x_max: 0 } force { x: 1 } } edge_loads { where { x_min: 0.1 x_max: 0.4 } "
             "force { x: 1 } }",
             "continuum.edge_loads[1].where", "holds no whole edge of the continuum's boundary"},
        Case{"body_load_nowhere", "body_loads { " + kNowhere + "acceleration { y: -10 } }",
             "continuum.body_loads[0].where", "selects no grid points"},
        Case{"motion_nowhere", "motions { " + kNowhere + "velocity { x: 0 } }", "continuum.motions[0].where",
             "selects no grid points"},
        Case{"motion_of_nothing", "motions { where { x_max: 0 } velocity {} }",
             "continuum.motions[0].velocity", "give x, y or both"},
        Case{"motions_contradict",
             "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } motions { where { y_max: 0 } velocity { "
             "y: 1 } }",
             "continuum.motions[1].velocity", "prescribes another y velocity than motions[0]"},
        Case{"body_beside_velocity",
             "motions { where { x_max: 0 } velocity { x: 1 } body { centre { x: 0 y: 0 } path: 'a' } }",
             "continuum.motions[0].body", "leave one out"},
        Case{"displacement_without_statics", "motions { where { x_max: 0 } displacement { x: 1 } }",
             "continuum.motions[0].displacement", "give `statics: {}`, or a `velocity`"},
        Case{"displacement_beside_velocity",
             "motions { where { x_max: 0 } velocity { x: 0 } displacement { x: 1 } }",
             "continuum.motions[0].displacement", "is given beside `velocity`", kBlock, kMaterial + kStatics},
        Case{"displacement_of_nothing", "motions { where { x_max: 0 } displacement {} }",
             "continuum.motions[0].displacement", "give x, y or both", kBlock, kMaterial + kStatics},
        Case{"displacements_contradict",
             "motions { where { x_max: 0 } displacement { x: 1 } } motions { where { x_max: 0 } displacement "
             "{ x: 2 } }",
             "continuum.motions[1].displacement", "prescribes another x displacement than motions[0]", kBlock,
             kMaterial + kStatics},
        Case{"stage_of_a_velocity", "motions { where { x_max: 0 } velocity { x: 0 } stage: 1 }",
             "continuum.motions[0].stage", "is that of a `displacement`", kBlock, kMaterial + kStatics},
        Case{"body_contradicts",
             "motions { where { x_max: 0 } velocity { y: 0 } } motions { where { x_max: 0 } body { centre { "
             "x: 0 "
             "y: 0 } path: 'a' content: 'time_s,vx_m_per_s,vy_m_per_s,spin_rad_per_s\\n0,0,0,0' } }",
             "continuum.motions[1].velocity", "prescribes another y velocity than motions[0]"},
        Case{"foundation_without_springs", "foundations { }", "continuum.foundations[0]",
             "springs in no direction"},
        Case{"foundation_nowhere", "foundations { " + kNowhere + "x { stiffness: 1 } }",
             "continuum.foundations[0].where", "selects no zones"},
        Case{"foundation_beside_stages",
             "foundations { x { stiffness: 1 } } excavations { where { x_max: 0.3 } stage: 1 }",
             "continuum.foundations", "excavations of later stages"},
        Case{"load_table",
             "point_loads { where { x_max: 0 } force { x: 1 } time { table { time: 0 time: 1 value: 0 } } }",
             "continuum.point_loads[0].time.table.value", "has 1 elements, expected 2, as many as `time`"},
        Case{"motion_table",
             "motions { where { x_max: 0 } velocity { x: 1 } time { table { time: 1 time: 0 value: 0 value: "
             "1 } } }",
             "continuum.motions[0].time.table.time[1]", "is 0 s, expected more than the 1 s before it"},
        Case{"history_of_no_lining", "histories { name: 'a' quantity: MOMENT at { x: 3 y: 1 } }",
             "continuum.histories[0].lining", "is missing; name the lining"},
        Case{"history_of_another_lining",
             kLining + "histories { name: 'a' quantity: THRUST at { x: 3 y: 1 } lining: 'tob' }",
             "continuum.histories[0].lining", "is `tob`, but no lining of the continuum has this name"},
        Case{"history_off_the_lining",
             kLining + "histories { name: 'a' quantity: THRUST at { x: 3 y: 0.5 } lining: 'top' }",
             "continuum.histories[0].at", "m from the lining's nearest node"},
        Case{"utilisation_of_an_elastic_lining",
             kLining + "histories { name: 'a' quantity: UTILISATION at { x: 3 y: 1 } lining: 'top' }",
             "continuum.histories[0].quantity", "but lining `top` is elastic; give it a `section`"},
        Case{"rotation_without_a_joint",
             kLining + "histories { name: 'a' quantity: ROTATION at { x: 3 y: 1 } lining: 'top' }",
             "continuum.histories[0].at", "where lining `top` has no joint of segments (`contact`)"},
        Case{"tightness_without_a_gasket",
             kSegments + "histories { name: 'a' quantity: TIGHTNESS at { x: 3 y: 1 } lining: 'top' }",
             "continuum.histories[0].quantity",
             "is of a gasket against water, which the joint at this place"},
        Case{"force_without_bolts",
             kSegments + "histories { name: 'a' quantity: BOLT_FORCE at { x: 3 y: 1 } lining: 'top' }",
             "continuum.histories[0].quantity", "is of bolts, which the joint at this place of lining `top`"},
        Case{"history_outside", "histories { name: 'a' quantity: VELOCITY_X at { x: 9 y: 0 } }",
             "continuum.histories[0].at",
             "is (9, 0) m, where the continuum has no zone; the nearest grid point of ground that stays is "
             "(6, "
             "0) m, put it inside"}),
    adit::test::kRefusalName);

// A scene without a continuum is not for this server.
TEST(SceneErrors, ContinuumIsMissing) {
  FdmParticipant participant;
  wire::Model model;
  adit::test::expect_refusal([&] { participant.set_up({}, model); }, "continuum", "");
}

// An overlap that leaves nothing of the continuum is refused.
TEST(SceneErrors, OverlapLeavesNoZone) {
  const Conversation whole("");
  wire::Weights weights;
  weights.mutable_weights()->Resize(whole.model.sample_points_size() / 2, 0.0);
  adit::test::expect_refusal([&] { Conversation("", weights); }, "interface.overlap", "leaves no zone");
}

// The continuum's own material is taken instead of the scene's: twice the stiffness, a critical step shorter
// by the root of 2.
TEST(SceneErrors, OwnMaterialReplacesTheScenes) {
  const Conversation of_scene("");
  const Conversation own("material { young_modulus: 50e9 poisson_ratio: 0.2 density: 2500 }");
  EXPECT_NEAR(own.model.critical_dt() * std::sqrt(2.0), of_scene.model.critical_dt(),
              1e-14 * of_scene.model.critical_dt());
}

// A step above the critical one is refused with both values.
TEST(SceneErrors, StepAboveTheCriticalOne) {
  Conversation run("");
  adit::test::expect_refusal([&] { run.advance(0, 1.01 * run.model.critical_dt()); }, "time.dt",
                             "above the continuum's critical step");
}

// Two motions that agree may share points: fixed corners of two fixed sides.
TEST(SceneErrors, AgreeingMotionsMayOverlap) {
  EXPECT_NO_THROW(Conversation(
      "motions { where { x_max: 0 } velocity { x: 0 y: 0 } } motions { where { y_max: 0 } velocity { x: "
      "0 y: 0 } }"));
}

}  // namespace
}  // namespace adit::fdm::test::scene_error_test
