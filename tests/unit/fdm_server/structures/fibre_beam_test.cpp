// Requirements on beams of reinforced concrete: elastic at first, the moments of their section beyond, the
// same thrust and shear all along, and an energy that is accounted for.
#include "fdm_server/structures/fibre_beam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "fdm_server/zones/critical_step.hpp"
#include "protocol/sections/moment_curvature.hpp"
#include "protocol/sections/section_materials.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"
#include "tests/unit/fdm_server/structures/frames.hpp"

namespace adit::fdm::test::fibre_beam_test {
namespace {

constexpr double kThickness = 0.3;

// C30/37 and B500B by mean values; more bars outside than inside.
std::shared_ptr<const LiningSection> section() {
  const sections::SectionShape shape{kThickness, 1, {{-0.1, 1005e-6, 0.016}, {0.1, 2010e-6, 0.016}}};
  const auto concrete = sections::concrete_values(*protocol::concrete_of("C30/37"), protocol::Values::kMean);
  const auto steel = protocol::steel_values(*protocol::steel_of("B500B"), protocol::Values::kMean);
  const auto law = sections::concrete_law(concrete, steel.yield / steel.young_modulus);
  return std::make_shared<const LiningSection>(
      LiningSection{std::make_shared<const sections::FibreSection>(shape, law, steel_law(steel)),
                    false,
                    {shape,
                     sections::Capacity(shape, sections::capacity_materials(concrete, steel)),
                     sections::shear_materials(concrete, steel, 0),
                     {}},
                    0.04,
                    concrete.young_modulus,
                    concrete.tensile});
}

Section elastic(const LiningSection& of) {
  return elastic_section(*of.fibres, of.concrete_modulus / 2.4, kRho, true);
}

Beam beam_of(const LiningSection& of, double length) {
  return {{0, 1}, {0, 1}, chord(0, 0, length, 0), elastic(of)};
}

// One more step, after which the beam carries no thrust.
BeamResultants without_thrust(FibreBeam& beam, double length, const BeamStrains& step) {
  BeamResultants forces = beam.strain(step);
  for (int i = 0; i < 400; ++i) forces = beam.strain({-forces.n * length / beam.section().axial(), 0, 0});
  return forces;
}

// Requirement: small strains give the forces of the elastic beam with its eccentric centroid.
TEST(FibreBeam, IsElasticAtFirst) {
  const auto of = section();
  const sections::FibreSection& fibres = *of->fibres;
  for (const double length : {0.3, 2.0}) {
    const Beam elastic_beam = beam_of(*of, length);
    FibreBeam beam(elastic_beam, of->fibres);
    const double z = fibres.centroid(), phi = elastic_beam.shear_flexibility();
    EXPECT_NE(z, 0);
    BeamResultants forces{};
    for (int i = 0; i < 10; ++i) forces = beam.strain({2e-8, -3e-8, 4e-8});
    const double thrust = fibres.axial() / length * (2e-7 - 3e-7 * z),
                 moment = fibres.bending() / length * -3e-7,
                 antisymmetric = 3 * fibres.bending() / length / (1 + phi) * 4e-7;
    EXPECT_NEAR(forces.n, thrust, 1e-3 * std::abs(thrust));
    EXPECT_NEAR(forces.b, moment + z * thrust, 1e-3 * std::abs(moment));
    EXPECT_NEAR(forces.s, antisymmetric, 1e-3 * antisymmetric);
    EXPECT_NEAR(beam.stored(),
                (thrust * thrust * length / fibres.axial() + moment * moment * length / fibres.bending() +
                 antisymmetric * 4e-7) /
                    2,
                2e-3 * beam.stored());
    EXPECT_NEAR(beam.dissipated(), 0, 2e-3 * beam.stored());
  }
}

// Requirement: in pure bending without thrust the moment is that of the section at this curvature.
TEST(FibreBeam, BendsAsItsSection) {
  const auto of = section();
  const double length = 0.4;
  for (const double sign : {1.0, -1.0}) {
    FibreBeam beam(beam_of(*of, length), of->fibres);
    std::vector<double> curvatures;
    for (int i = 1; i <= 20; ++i) curvatures.push_back(sign * 1e-3 * i);
    for (const sections::CurvaturePoint& point : moment_curvature(*of->fibres, 0, curvatures)) {
      const BeamResultants forces = without_thrust(beam, length, {0, sign * 1e-3 * length, 0});
      EXPECT_NEAR(forces.b, point.moment, 0.01 * std::abs(point.moment)) << point.curvature;
      EXPECT_NEAR(forces.s, 0, 1e-6 * std::abs(forces.b));
      EXPECT_NEAR(beam.curvature(0), point.curvature, 1e-9);
    }
  }
}

// Requirement: antisymmetric bending far beyond yield is limited by the moments of the two sections, also of
// a beam as short as thick, whose elastic shear would otherwise go on carrying.
TEST(FibreBeam, ShearFollowsTheMoments) {
  const auto of = section();
  for (const double length : {0.3, 1.5}) {
    FibreBeam beam(beam_of(*of, length), of->fibres);
    BeamResultants forces{};
    // To a curvature of about 0.08/m at the sections, where the weaker side has reached its ultimate moment.
    for (int i = 0; i < 500; ++i) forces = without_thrust(beam, length, {0, 0, 0.045 * length / 500});
    const double inner = of->strength.capacity.moment(sections::Bending::kInnerStretched, 0),
                 outer = of->strength.capacity.moment(sections::Bending::kOuterStretched, 0);
    // M = B -+ S/sqrt 3 at the two sections.
    EXPECT_NEAR(forces.b + forces.s / std::sqrt(3.0), outer, 0.02 * outer);
    EXPECT_NEAR(forces.b - forces.s / std::sqrt(3.0), inner, 0.02 * -inner);
  }
}

// Requirement: kinetic, strain and dissipated energy less work keep their first value to rounding while the
// lining cracks, crushes and yields, in steps of the lining and in those of the ground.
TEST(FibreBeam, LedgerClosesToRounding) {
  const auto of = section();
  for (const bool long_steps : {false, true}) {
    const Block ground{0, 8, 0, 4, 8, 4};
    const Grid grid = make_grid(ground);
    const PlaneLaw law = plane_strain(2e9, 0.3);
    Structures structures;
    const Path path{{19, 20, 21, 22, 23, 24, 25}, false};
    const LiningPlan plan{"roof", path, elastic(*of), {}, true, false, of};
    add_lining(plan, grid, structures);
    auto masses = lumped_masses(grid, ones(grid), 2000);
    structures.add_masses(masses);
    double dt = 0.8 * critical_step(ZoneKind::kAssumedStrain, grid, law, 2000);
    if (!long_steps) dt = std::min(dt, 0.8 * structures.critical_step());
    const auto shake = [](double t) { return std::cos(150 * t); };
    const std::vector<std::uint32_t> base{0, 1, 2, 3, 4, 5, 6, 7, 8};
    Continuum continuum(
        ZoneSet(ZoneKind::kAssumedStrain, grid, law, ones(grid)), masses,
        {Load{{22, 44}, {4e6, 0}, {-8e6, 3e6}, shake}},
        {PrescribedMotion{base, Axis::kX, 0.5, shake}, PrescribedMotion{base, Axis::kY, 0.2, shake}}, 1,
        structures);
    EXPECT_EQ(continuum.longer_than_structures(dt), long_steps);
    Energies first{}, last{};
    continuum.step({0, dt}, &first);
    double peak = 0, drift = 0, cracked = 0;
    for (std::uint64_t n = 1; n <= 10000; ++n) {
      continuum.step({n, dt}, &last);
      peak = std::max({peak, last.kinetic, last.strain});
      drift =
          std::max(drift, std::abs(last.kinetic + last.strain + last.dissipated - last.external_work -
                                   (first.kinetic + first.strain + first.dissipated - first.external_work)));
      cracked = std::max(cracked, continuum.structures().fibres(2)->states(0).steel_strain(*of->fibres));
    }
    EXPECT_LE(drift, 1e-10 * peak);
    EXPECT_GE(last.dissipated, 1e-3 * peak);
    EXPECT_GE(cracked, 3e-4);
  }
}

}  // namespace
}  // namespace adit::fdm::test::fibre_beam_test
