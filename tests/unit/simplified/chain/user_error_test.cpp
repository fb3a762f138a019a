// Every chain that cannot be computed: the error names the field and says what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "protocol/errors.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::user_error_test {
namespace {

using Case = adit::test::Refusal<std::function<void(Chain&, Settings&)>>;
class UserErrors : public testing::TestWithParam<Case> {};

TEST_P(UserErrors, NamesTheFieldAndTheRemedy) {
  Chain chain = test::winding(4);
  Settings settings{.dt = 0.005};
  GetParam().input(chain, settings);
  adit::test::expect_refusal([&] { const Simulation run(chain, settings); }, GetParam().path,
                             GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, UserErrors,
    testing::Values(
        Case{"NoBodies", "chain.bodies", "holds no body", [](auto& c, auto&) { c = {}; }},
        Case{"HingeMissing", "chain.hinges", "holds 2 hinge(s) for 4 bodies: give 3",
             [](auto& c, auto&) { c.hinges.pop_back(); }},
        Case{"NoLength", "chain.bodies[2].length", "above 0", [](auto& c, auto&) { c.bodies[2].length = 0; }},
        Case{"NoMass", "chain.bodies[3].mass", "above 0", [](auto& c, auto&) { c.bodies[3].mass = -1; }},
        Case{"NoInertia", "chain.bodies[0].inertia", "above 0",
             [](auto& c, auto&) { c.bodies[0].inertia = NAN; }},
        Case{"AngleNotFinite", "chain.bodies[1].angle", "not a finite number",
             [](auto& c, auto&) { c.bodies[1].angle = INFINITY; }},
        Case{"TurnsBack", "chain.bodies[1].angle", "goes on forwards",
             [](auto& c, auto&) { c.bodies[1].angle += 2; }},
        Case{"NegativeGround", "chain.bodies[1].ground_stiffness.lateral", "0 or above",
             [](auto& c, auto&) { c.bodies[1].ground_stiffness.lateral = -1; }},
        Case{"NegativeGroundDashpot", "chain.bodies[1].ground_dashpot.axial", "0 or above",
             [](auto& c, auto&) { c.bodies[1].ground_dashpot.axial = -1; }},
        Case{"NegativeHinge", "chain.hinges[2].shear.stiffness", "0 or above",
             [](auto& c, auto&) { c.hinges[2].shear.stiffness = -1; }},
        Case{"NegativeAbutment", "chain.start.rotation.dashpot", "0 or above",
             [](auto& c, auto&) { c.start->rotation.dashpot = -1; }},
        Case{"CurveAndStiffness", "chain.hinges[0].axial.curve", "give one of the two",
             [](auto& c, auto&) {
               c.hinges[0].axial.curve = {{0, 1}, {0, 1}};
             }},
        Case{"CurveTooShort", "chain.hinges[0].axial.curve.deformation", "2 or more",
             [](auto& c, auto&) {
               c.hinges[0].axial = {0, 0, Curve{{0}, {0}}};
             }},
        Case{"CurveUneven", "chain.hinges[0].axial.curve.force", "3 value(s) for 2 deformations",
             [](auto& c, auto&) {
               c.hinges[0].axial = {0, 0, Curve{{0, 1}, {0, 1, 2}}};
             }},
        Case{"CurveGoesBack", "chain.hinges[0].axial.curve.deformation[2]", "must increase",
             [](auto& c, auto&) {
               c.hinges[0].axial = {0, 0, Curve{{0, 1, 1}, {0, 1, 2}}};
             }},
        Case{"CurveNotMonotone", "chain.hinges[0].axial.curve.force[2]", "must not decrease",
             [](auto& c, auto&) {
               c.hinges[0].axial = {0, 0, Curve{{0, 1, 2}, {0, 2, 1}}};
             }},
        Case{"CurveNotFinite", "chain.finish.axial.curve.force[1]", "not a finite number",
             [](auto& c, auto&) {
               c.finish = Hinge{};
               c.finish->axial.curve = {{0, 1}, {0, NAN}};
             }},
        Case{"NoStep", "dt", "above 0", [](auto&, auto& s) { s.dt = 0; }},
        Case{"UnstableGamma", "integrator.gamma", "would grow",
             [](auto&, auto& s) {
               s.newmark = Newmark{0.25, 0.4};
             }},
        Case{"UnstableBeta", "integrator.beta", "gamma / 2",
             [](auto&, auto& s) {
               s.newmark = Newmark{1.0 / 6, 0.5};
             }},
        Case{"Tolerance", "tolerance", "between 0 and 1", [](auto&, auto& s) { s.tolerance = 0; }},
        Case{"Iterations", "max_iterations", "below 1", [](auto&, auto& s) { s.max_iterations = 0; }}),
    adit::test::kRefusalName);

// Values for another number of bodies are the caller's error, by name.
TEST(Excitation, WrongSizeIsRefused) {
  Simulation run(test::segments(3), {.dt = 0.01});
  const std::vector<double> two(2);
  EXPECT_THROW(run.step({.ground_vx = two}), std::invalid_argument);
}

}  // namespace
}  // namespace adit::simplified::chain::user_error_test
