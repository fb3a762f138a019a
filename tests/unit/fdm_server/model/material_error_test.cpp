// Every error of a scene's materials: the field's path and a sentence that says what to do; and that what is
// written is what is computed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "fdm_server/model/ground.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/fdm_server/scenes.hpp"

namespace adit::fdm::test::material_error_test {
namespace {

using testing::HasSubstr;

// A scene in plane strain whose material has `law`.
wire::Setup ground_of(const std::string& law, const std::string& continuum = "",
                      const std::string& plane = "PLANE_STRAIN") {
  return setup_of(
      continuum, kBlock,
      "plane: " + plane + " material { young_modulus: 1e9 poisson_ratio: 0.3 density: 2000 " + law + " }");
}

struct Case {
  std::string name, law, path, message;
  std::string continuum = "", plane = "PLANE_STRAIN";
};
class MaterialError : public testing::TestWithParam<Case> {};

TEST_P(MaterialError, NamesTheFieldAndTheRemedy) {
  const Case& refused = GetParam();
  FdmParticipant participant;
  wire::Model model;
  adit::test::expect_refusal(
      [&] { set_up(participant, ground_of(refused.law, refused.continuum, refused.plane), model); },
      refused.path, refused.message);
}

const std::string kSoil = "young_modulus: 1e8 poisson_ratio: 0.3 density: 1800 ";

INSTANTIATE_TEST_SUITE_P(
    Scenes, MaterialError,
    testing::Values(
        Case{"cohesion", "mohr_coulomb { cohesion: -1 }", "material.mohr_coulomb.cohesion",
             "is -1 Pa, expected a pressure of at least 0 Pa"},
        Case{"degrees", "mohr_coulomb { cohesion: 1e3 friction_angle: 30 }",
             "material.mohr_coulomb.friction_angle",
             "is 30 rad, expected an angle of at least 0 rad and below"},
        Case{"fracture", "fracture { tensile_strength: 1e6 fracture_energy: 50 }", "material.fracture",
             "needs one of compressive_strength and cohesion; give exactly one"},
        Case{"fracture_strength", "fracture { tensile_strength: 1e6 fracture_energy: 50 cohesion: 0.5e6 }",
             "material.fracture.cohesion", "below the tensile_strength of 1e+06 Pa"},
        Case{"dilation", "mohr_coulomb { cohesion: 1e3 friction_angle: 0.3 dilation_angle: 0.4 }",
             "material.mohr_coulomb.dilation_angle", "more than the friction angle of 0.3 rad"},
        Case{"tension", "mohr_coulomb { cohesion: 1e3 friction_angle: 0.785398163397 tension: 2e3 }",
             "material.mohr_coulomb.tension", "must be at most cohesion / tan(friction_angle) = 1000"},
        Case{"softening_strain",
             "mohr_coulomb { cohesion: 1e3 softening { plastic_shear_strain: 0.1 } softening { "
             "plastic_shear_strain: 0.05 } }",
             "material.mohr_coulomb.softening[1].plastic_shear_strain", "must be larger than 0.1 before it"},
        Case{"softening_dilation",
             "mohr_coulomb { cohesion: 1e3 friction_angle: 0.5 dilation_angle: 0.2 softening { "
             "plastic_shear_strain: 0.1 friction_angle: 0.1 } }",
             "material.mohr_coulomb.softening[0].dilation_angle", "would gain energy"},
        Case{"remoulding_beside_softening",
             "mohr_coulomb { cohesion: 1e3 softening { plastic_shear_strain: 0.1 } remoulding { sensitivity: "
             "4 } "
             "}",
             "material.mohr_coulomb.remoulding", "beside `softening`"},
        Case{"remoulding_with_friction",
             "mohr_coulomb { cohesion: 1e3 friction_angle: 0.5 remoulding { sensitivity: 4 } }",
             "material.mohr_coulomb.remoulding", "leave `friction_angle` out"},
        Case{"sand_without_resistance", "pm4sand { relative_density: 0.55 }", "material.pm4sand",
             "states no resistance; give `cyclic_resistance`, or `contraction_rate`"},
        Case{"sand_too_weak", "pm4sand { relative_density: 0.55 cyclic_resistance: 0.06 }",
             "material.pm4sand.cyclic_resistance",
             "is 0.06, but with relative_density 0.55 and modulus_coefficient 676.6 only 0.0676 to 0.277 can "
             "be reached"},
        Case{"sand_too_strong",
             "pm4sand { relative_density: 0.55 modulus_coefficient: 500 cyclic_resistance: 0.3 }",
             "material.pm4sand.cyclic_resistance", "modulus_coefficient 500 only"},
        Case{"no_curve", "hysteretic {}", "material.hysteretic", "names no curve; give table or hyperbola"},
        Case{"masing_damping", "hysteretic { hyperbola { reference_strain: 1e-3 } damping { darendeli {} } }",
             "material.hysteretic.damping", "needs `memory: reversals`"},
        Case{"no_damping_curve",
             "hysteretic { hyperbola { reference_strain: 1e-3 } memory: REVERSALS damping {} }",
             "material.hysteretic.damping", "names no curve; give table or darendeli"},
        Case{"damping_of_two",
             "hysteretic { hyperbola { reference_strain: 1e-3 } memory: REVERSALS damping { table { "
             "shear_strain: 1e-5 shear_strain: 1e-4 shear_strain: 1e-3 ratio: 0.01 ratio: 0.1 } } }",
             "material.hysteretic.damping.table.ratio",
             "has 2 elements, expected 3, as many as `shear_strain`"},
        Case{
            "damping_that_ends",
            "hysteretic { hyperbola { reference_strain: 1e-3 } memory: REVERSALS damping { table { "
            "shear_strain: 1e-5 shear_strain: 1e-3 shear_strain: 1.05e-3 ratio: 0.01 ratio: 0.2 ratio: 0.001 "
            "} } }",
            "material.hysteretic.damping", "give back more energy than it took"},
        Case{"reversals_within_a_strength",
             "mohr_coulomb { cohesion: 1 } hysteretic { hyperbola { reference_strain: 1e-3 } memory: "
             "REVERSALS }",
             "material.hysteretic.memory", "is `reversals` beside mohr_coulomb"},
        Case{"reversals_beside_a_plane",
             "weak_plane { dip_angle: 1 cohesion: 1 } hysteretic { hyperbola { reference_strain: 1e-3 } "
             "memory: "
             "REVERSALS }",
             "material.hysteretic.memory", "is `reversals` beside weak_plane"},
        Case{"percent", "hysteretic { hyperbola { reference_strain: 5 } }",
             "material.hysteretic.hyperbola.reference_strain",
             "is 5, expected a pure number above 0 and below 1"},
        Case{"counts",
             "hysteretic { table { shear_strain: 1e-5 shear_strain: 1e-4 shear_strain: 1e-3 ratio: 1 ratio: "
             "0.8 } }",
             "material.hysteretic.table.ratio", "has 2 elements, expected 3, as many as `shear_strain`"},
        Case{"order",
             "hysteretic { table { shear_strain: 1e-5 shear_strain: 1e-3 shear_strain: 1e-4 ratio: 1 ratio: "
             "0.8 "
             "ratio: 0.5 } }",
             "material.hysteretic.table.shear_strain[2]", "before it"},
        Case{"rising",
             "hysteretic { table { shear_strain: 1e-5 shear_strain: 1e-4 shear_strain: 1e-3 ratio: 1 ratio: "
             "0.8 "
             "ratio: 0.9 } }",
             "material.hysteretic.table.ratio", "at its value 3: 0.9"},
        Case{"first_ratio",
             "hysteretic { table { shear_strain: 1e-5 shear_strain: 1e-4 shear_strain: 1e-3 ratio: 0.9 "
             "ratio: 0.8 "
             "ratio: 0.5 } }",
             "material.hysteretic.table.ratio", "begins with 0.9"},
        Case{"falling_stress",
             "hysteretic { table { shear_strain: 1e-5 shear_strain: 1e-4 shear_strain: 2e-4 ratio: 1 ratio: "
             "0.8 "
             "ratio: 0.3 } }",
             "material.hysteretic.table.ratio", "this law cannot soften"},
        Case{"plane_stress", "mohr_coulomb { cohesion: 1e3 }", "material", "in plane strain only", "",
             "PLANE_STRESS"},
        Case{"large_strain_in_plane_stress", "", "continuum.large_strain", "in plane strain only",
             "large_strain: true", "PLANE_STRESS"},
        Case{"area_nowhere", "", "continuum.materials[0].where", "selects no zones",
             "materials { where { x_min: 7 } material { " + kSoil + " } }"},
        Case{"area_material", "", "continuum.materials[1].material.young_modulus",
             "is missing; write for example",
             "materials { where {} material { " + kSoil +
                 " } } materials { where {} material { density: 1 } }"}),
    adit::test::kRefusalName);

// Later areas override earlier ones; the base material fills the rest.
TEST(Materials, LaterAreasOverrideEarlierOnes) {
  const auto setup =
      ground_of("", "materials { where { x_max: 4 } material { " + kSoil +
                        " } } materials { where { x_min: 2 x_max: 3 } material { " + kSoil + " } }");
  const Grid grid = make_grid({0, 6, 0, 1, 6, 1});
  EXPECT_EQ(materials_of_zones(setup.scene().continuum(), grid),
            (std::vector<std::uint32_t>{1, 1, 2, 1, 0, 0}));
}

// The critical step is that of the stiffest and lightest zone, wherever it lies.
TEST(Materials, CriticalStepIsThatOfTheStiffestZone) {
  FdmParticipant all, some;
  wire::Model soft, stiff;
  all.set_up(ground_of(""), soft);
  some.set_up(
      ground_of("",
                "materials { where { x_max: 1 } material { young_modulus: 4e9 poisson_ratio: 0.3 density: "
                "2000 mohr_coulomb { cohesion: 1e3 } } }"),
      stiff);
  EXPECT_NEAR(stiff.critical_dt(), soft.critical_dt() / 2, 1e-12 * soft.critical_dt());
}

// What is left out of a row of softening stays as in the row before, and the tension never leaves the cone.
TEST(Materials, SofteningRowsKeepWhatTheyLeaveOut) {
  const auto setup = ground_of(
      "mohr_coulomb { cohesion: 1e3 friction_angle: 0.5 softening { plastic_shear_strain: 0.01 cohesion: 100 "
      "} "
      "softening { plastic_shear_strain: 0.03 friction_angle: 0.4 } }");
  const auto ground = read_ground(setup.scene());
  const auto& law = *ground.materials[0].mohr_coulomb;
  EXPECT_DOUBLE_EQ(law.strength(0.005).cohesion, 550);
  EXPECT_DOUBLE_EQ(law.strength(0.02).cohesion, 100);
  EXPECT_DOUBLE_EQ(law.strength(0.02).friction_angle, 0.45);
  EXPECT_DOUBLE_EQ(law.strength(1).friction_angle, 0.4);
  EXPECT_DOUBLE_EQ(law.strength(1).tension, 100 / std::tan(0.5));
}

// The strength of remoulded clay follows Einav and Randolph's curve, from the undisturbed to the remoulded
// one.
TEST(Materials, ClayIsRemoulded) {
  const auto setup = ground_of("mohr_coulomb { cohesion: 40e3 remoulding { sensitivity: 4 strain_95: 20 } }");
  const auto ground = read_ground(setup.scene());
  const auto& law = *ground.materials[0].mohr_coulomb;
  for (const double strain : {0.0, 0.3, 1.0, 5.0, 20.0, 33.0})
    EXPECT_NEAR(law.strength(strain).cohesion, 10e3 + 30e3 * std::exp(-3 * strain / 20), 0.005 * 30e3)
        << strain;
  EXPECT_NEAR(law.strength(1000).cohesion, 10e3, 0.003 * 30e3);
}

}  // namespace
}  // namespace adit::fdm::test::material_error_test
