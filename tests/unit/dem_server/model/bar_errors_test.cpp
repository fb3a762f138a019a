// Every bar that cannot be computed: the error names the field and says what to do.
#include <gtest/gtest.h>

#include <functional>

#include "dem_server/model/reading/read_model.hpp"
#include "protocol/scene/fields/check_rules.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/dem_server/barred_scene.hpp"

namespace adit::dem::bar_errors_test {
namespace {

void compute(const scene::Scene& scene) {
  protocol::check_rules(scene);
  read_model(scene);
}

using Case = adit::test::Refusal<std::function<void(scene::Scene&)>>;
class BarErrors : public testing::TestWithParam<Case> {};

TEST_P(BarErrors, NameTheFieldAndTheRemedy) {
  auto scene = test::barred_member();
  GetParam().input(scene);
  adit::test::expect_refusal([&] { compute(scene); }, GetParam().path, GetParam().message);
}

TEST(BarErrors, TheSceneThatTheySpoilIsComputed) {
  EXPECT_NO_THROW(compute(test::barred_member()));
}

scene::ParticleBar& bar(scene::Scene& s) {
  return *s.mutable_particles()->mutable_bars(0);
}
scene::RoundPath& circle(scene::Scene& s) {
  auto& round = *bar(s).mutable_along()->mutable_circle();
  test::set(*round.mutable_centre(), 0.5, 0.1);
  round.set_radius(0.06);
  return round;
}

INSTANTIATE_TEST_SUITE_P(
    OfSteel, BarErrors,
    testing::Values(
        Case{"NoArea", "particles.bars[0]", "needs its steel once: give either `spacing` or `area`",
             [](auto& s) { bar(s).clear_spacing(); }},
        Case{"AreaTwice", "particles.bars[0]", "needs its steel once: give either `spacing` or `area`",
             [](auto& s) { bar(s).set_area(1e-3); }},
        Case{"NoDiameter", "particles.bars[0].diameter", "is missing",
             [](auto& s) { bar(s).clear_diameter(); }},
        Case{"UnknownClass", "particles.bars[0].steel.class", "is `B500D`, expected a class of EN 1992-1-1",
             [](auto& s) { bar(s).mutable_steel()->set_class_("B500D"); }},
        Case{"NoStrength", "particles.bars[0].steel", "needs its strength once",
             [](auto& s) { bar(s).mutable_steel()->clear_class_(); }},
        Case{"ValuesOfNumbers", "particles.bars[0].values", "chooses among the values of a class",
             [](auto& s) {
               bar(s).mutable_steel()->clear_class_();
               bar(s).mutable_steel()->set_yield_strength(500e6);
               bar(s).set_values(scene::ReinforcedSection::DESIGN);
             }},
        Case{"NoConcrete", "particles.bars[0].concrete_strength",
             "is missing, and the particles' material has no `fracture` that states it; give it",
             [](auto& s) { s.mutable_material()->clear_fracture(); }},
        Case{"SlipsOutOfOrder", "particles.bars[0].bond.plateau_slip", "at least",
             [](auto& s) { bar(s).mutable_bond()->set_plateau_slip(1e-4); }}),
    adit::test::kRefusalName);

INSTANTIATE_TEST_SUITE_P(
    OfPath, BarErrors,
    testing::Values(
        Case{"NoPath", "particles.bars[0].along", "names no path; give `circle` or `line`",
             [](auto& s) { bar(s).mutable_along()->clear_line(); }},
        Case{"ThroughNoParticles", "particles.bars[0].along",
             "passes through 0 particles, and a bar is held by 2 and more; lead it through them",
             [](auto& s) {
               for (auto& point : *bar(s).mutable_along()->mutable_line()->mutable_points()) point.set_y(5);
             }},
        Case{"OutOfTheParticles", "particles.bars[0].along",
             "leaves the particles at (0.5, 0.2) m for 1 m; end the bar there, or lead it through particles",
             [](auto& s) {
               auto& line = *bar(s).mutable_along()->mutable_line();
               line.clear_points();
               for (const auto& [x, y] : {std::pair{0.5, 0.05}, {0.5, 0.6}, {0.7, 0.6}, {0.7, 0.05}})
                 test::set(*line.add_points(), x, y);
             }},
        Case{"BackOverItself", "particles.bars[0].along.line.points",
             "cross, touch or run back over one another",
             [](auto& s) { test::set(*bar(s).mutable_along()->mutable_line()->add_points(), 0.5, 0.1); }},
        Case{"OneEndOfAnArc", "particles.bars[0].along.circle", "names one end of an arc",
             [](auto& s) { circle(s).set_from(1); }},
        Case{"ArcBackwards", "particles.bars[0].along.circle.to", "must be larger than `from`",
             [](auto& s) {
               circle(s).set_from(1);
               circle(s).set_to(0.5);
             }},
        Case{"StageWithoutStatics", "particles.bars[0].stage", "the scene has no statics",
             [](auto& s) { bar(s).set_stage(1); }}),
    adit::test::kRefusalName);

}  // namespace
}  // namespace adit::dem::bar_errors_test
