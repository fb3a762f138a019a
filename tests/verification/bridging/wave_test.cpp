// Requirement: waves that run through the overlap from the particles' side are reflected, transmitted and
// lost as an independent one-dimensional program of the same method computes (chain_and_bar.hpp), to 1 %.
// They also agree roughly with the table of the published prototypes, whose packets are Gaussian but of
// unknown width, on which all figures near the grid's cut-off (λ = π h) depend. The consistent solve loses
// nothing, which is tested exactly.
//
// The bar is one row of particles and one row of zones: a chain of springs that meets 1-D elements.
// Spacing a = 1, wave speed 1, zones h = 10 a, overlap 5 h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "coupler/stepping/stepper.hpp"
#include "tests/support/local_participants.hpp"
#include "tests/verification/bridging/chain_and_bar.hpp"

namespace adit::wave_test {
namespace {

constexpr double kZone = 10, kOverlap = 5 * kZone, kStep = 0.5, kLongStep = 0.8;

struct Shares {
  double reflected, transmitted, lost;  // of the packet's energy
};

// A packet of mean wavelength λ with a Gaussian envelope of the displacement, as wide as one period, sent by
// the velocity of the chain's end.
struct Packet {
  double wavelength;
  double omega() const { return 2 * std::sin(std::numbers::pi / wavelength); }  // the chain's dispersion
  double group_velocity() const { return std::cos(std::numbers::pi / wavelength); }
  double width() const { return 2 * std::numbers::pi / omega(); }  // standard deviation [s]
  double duration() const { return 10 * width(); }
  double velocity(double t) const {
    const double s = (t - duration() / 2) / width();
    const double phase = omega() * (t - duration() / 2);
    return std::exp(-s * s / 2) * (std::cos(phase) - s / (omega() * width()) * std::sin(phase));
  }
};

const double kSection = std::numbers::sqrt3 / 2;  // height of one row

struct Geometry {
  double chain, length,
      duration;  // the chain's end, the whole length [a]; time to send the packet through [a/c]

  // The packet leaves the source, and then needs as long again to pass.
  explicit Geometry(const Packet& packet) {
    const double travel = packet.duration() * packet.group_velocity() + 100;
    chain = std::ceil(travel / kZone) * kZone + kOverlap;
    length = chain + std::ceil(1.3 * packet.duration() / kZone) * kZone + 2 * kOverlap;
    duration = std::ceil(packet.duration() + (chain - kOverlap) / packet.group_velocity() + 2 * kOverlap);
  }
};

scene::Scene bar(const Packet& packet, scene::Solve solve, double dt) {
  const auto [chain, length, duration] = Geometry(packet);
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_material()->set_young_modulus(1);
  scene.mutable_material()->set_poisson_ratio(0);
  scene.mutable_material()->set_density(1);
  scene.mutable_time()->set_dt(dt);
  scene.mutable_time()->set_duration(duration);

  auto& particles = *scene.mutable_particles();
  auto& packing = *particles.mutable_packing();
  packing.set_x_min(0);
  packing.set_x_max(length);
  packing.set_y_min(0);
  packing.set_y_max(kSection);
  packing.set_radius(0.5);
  // A single row has no slanting bonds: its springs alone must be as stiff as the bar.
  particles.mutable_bonds()->set_normal_stiffness(kSection);
  particles.mutable_bonds()->set_shear_stiffness(0);
  auto& source = *particles.add_motions();
  source.mutable_where()->set_x_max(0.6);
  source.mutable_velocity()->set_x(1e-6);
  auto& table = *source.mutable_time()->mutable_table();
  for (double t = 0; t <= packet.duration(); t += 0.125) {
    table.add_time(t);
    table.add_value(packet.velocity(t));
  }

  auto& block = *scene.mutable_continuum()->mutable_block();
  block.set_x_min(0);
  block.set_x_max(length);
  block.set_y_min(0);
  block.set_y_max(kSection);
  block.set_zones_x(static_cast<std::uint32_t>(length / kZone + 0.5));
  block.set_zones_y(1);

  auto& overlap = *scene.mutable_interface()->mutable_overlap();
  overlap.mutable_particles_begin()->set_x(chain);
  overlap.mutable_particles_begin()->set_y(0);
  overlap.mutable_continuum_ends()->set_x(chain - kOverlap);
  overlap.mutable_continuum_ends()->set_y(0);
  scene.mutable_interface()->set_solve(solve);
  return scene;
}

// The same bar by regions: the chain is the outer model, the bar of zones lies within it.
scene::Scene with_the_chain_outside(scene::Scene scene) {
  auto &zones = *scene.add_regions(), &chain = *scene.add_regions();
  zones.set_name("zones");
  chain.set_name("chain");
  *zones.mutable_continuum() = scene.continuum();
  *chain.mutable_particles() = scene.particles();
  auto& interface = *scene.add_interfaces() = scene.interface();
  interface.set_outer("chain");
  interface.set_inner("zones");
  const auto [chain_ends, zones_begin] = std::pair{scene.interface().overlap().particles_begin().x(),
                                                   scene.interface().overlap().continuum_ends().x()};
  interface.mutable_overlap()->mutable_particles_begin()->set_x(zones_begin);
  interface.mutable_overlap()->mutable_continuum_ends()->set_x(chain_ends);
  scene.clear_continuum();
  scene.clear_particles();
  scene.clear_interface();
  return scene;
}

Shares send_through(const scene::Scene& scene) {
  coupler::Model model = test::local_model(scene);
  coupler::Stepper stepper(model);
  for (std::uint64_t n = 0; n <= model.steps; ++n) stepper.step(n, {.energies = n == model.steps});
  const auto& energies = stepper.ledger().energies();
  const double incident = energies[1].external_work;
  const double transmitted = (energies[0].kinetic + energies[0].strain) / incident;
  const double reflected = (energies[1].kinetic + energies[1].strain) / incident;
  return {reflected, transmitted, 1 - reflected - transmitted};
}

Shares send(double wavelength, scene::Solve solve, double dt = kStep) {
  return send_through(bar(Packet{wavelength}, solve, dt));
}

Shares send_by_independent_program(double wavelength, scene::Solve solve) {
  const auto kind = solve == scene::CONSISTENT ? test::ChainSolve::kConsistent
                    : solve == scene::LUMPED   ? test::ChainSolve::kLumped
                                               : test::ChainSolve::kSplit;
  const Packet packet{wavelength};
  const Geometry geometry(packet);
  const auto energies = test::simulate(
      {.section = kSection,
       .zone = kZone,
       .begin = geometry.chain - kOverlap,
       .end = geometry.chain,
       .length = geometry.length,
       .dt = kStep,
       .solve = kind,
       .decay_rate = 25 / kOverlap,  // the default: 25 wave speeds over the width
       .source = [&](double t) { return t < packet.duration() ? 1e-6 * packet.velocity(t) : 0.0; }},
      static_cast<std::size_t>(std::lround(geometry.duration / kStep)));
  const double transmitted = energies.bar / energies.incident, reflected = energies.chain / energies.incident;
  return {reflected, transmitted, 1 - reflected - transmitted};
}

void expect_independent_program_agrees(double wavelength, scene::Solve solve, const Shares& shares) {
  const Shares other = send_by_independent_program(wavelength, solve);
  EXPECT_NEAR(shares.reflected, other.reflected, 1e-3 * other.reflected + 1e-6);
  EXPECT_NEAR(shares.transmitted, other.transmitted, 1e-3 * other.transmitted + 1e-6);
  EXPECT_NEAR(shares.lost, other.lost, 1e-3 * std::abs(other.lost) + 1e-6);
}

struct Row {
  double ratio;            // λ/h
  double reflected, lost;  // of the incident energy [%]
  double reflected_tolerance, lost_tolerance;
};

class ConsistentWave : public testing::TestWithParam<Row> {};
class LumpedWave : public testing::TestWithParam<Row> {};

TEST_P(ConsistentWave, IsPassedOrReflectedButNeverLost) {
  const Row row = GetParam();
  const Shares shares = send(row.ratio * kZone, scene::CONSISTENT);
  EXPECT_NEAR(100 * shares.reflected, row.reflected, row.reflected_tolerance);
  EXPECT_NEAR(shares.lost, 0, 1e-9);
  expect_independent_program_agrees(row.ratio * kZone, scene::CONSISTENT, shares);
}

TEST_P(LumpedWave, IsPassedReflectedOrAbsorbed) {
  const Row row = GetParam();
  const Shares shares = send(row.ratio * kZone, scene::LUMPED);
  EXPECT_NEAR(100 * shares.reflected, row.reflected, row.reflected_tolerance);
  EXPECT_NEAR(100 * shares.lost, row.lost, row.lost_tolerance);
  expect_independent_program_agrees(row.ratio * kZone, scene::LUMPED, shares);
}

// Tests are named by λ/h.
std::string name_of_ratio(double ratio) {
  return ratio < 1 ? "Half" : std::to_string(static_cast<int>(ratio));
}
std::string name_of(const testing::TestParamInfo<Row>& info) {
  return name_of_ratio(info.param.ratio);
}

INSTANTIATE_TEST_SUITE_P(Rows, ConsistentWave,
                         testing::Values(Row{20, 0.007, 0, 0.001, 0}, Row{10, 0.014, 0, 0.005, 0},
                                         Row{5, 0.20, 0, 0.1, 0}, Row{4, 0.92, 0, 0.5, 0},
                                         Row{3, 72, 0, 6, 0}, Row{2, 100, 0, 0.5, 0}, Row{1, 100, 0, 0.01, 0},
                                         Row{0.5, 100, 0, 0.01, 0}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Rows, LumpedWave,
                         testing::Values(Row{20, 0.009, 0.1, 0.001, 0.05}, Row{10, 0.004, 1.1, 0.001, 0.2},
                                         Row{5, 0.055, 11, 0.02, 1}, Row{4, 0.32, 23, 0.3, 3},
                                         Row{3, 21, 62, 4, 9}, Row{2, 24, 76, 1, 1},
                                         Row{1, 1.4, 98.6, 0.6, 0.6}, Row{0.5, 0.5, 99.5, 0.1, 0.1}),
                         name_of);

struct Bounds {
  double ratio;            // λ/h
  double reflected, lost;  // at most [%]; 100 where nothing is asked
};

class SplitWave : public testing::TestWithParam<Bounds> {};

TEST_P(SplitWave, IsAsTheIndependentProgramSays) {
  const double wavelength = GetParam().ratio * kZone;
  expect_independent_program_agrees(wavelength, scene::SPLIT, send(wavelength, scene::SPLIT));
}

// Requirement: it is the same whichever of the two is called the outer model.
TEST_P(SplitWave, IsTheSameWithTheParticlesOutside) {
  const double wavelength = GetParam().ratio * kZone;
  expect_independent_program_agrees(
      wavelength, scene::SPLIT,
      send_through(with_the_chain_outside(bar(Packet{wavelength}, scene::SPLIT, kStep))));
}

// Requirement: the bounds hold, and the figures stay within 10 % (λ ≥ h), when the time step is changed by 8.
TEST_P(SplitWave, IsPassedOrAbsorbedWhateverTheTimeStep) {
  const auto [ratio, reflected, lost] = GetParam();
  const Shares at_long = send(ratio * kZone, scene::SPLIT, kLongStep);
  const Shares at_short = send(ratio * kZone, scene::SPLIT, kLongStep / 8);
  for (const Shares& shares : {at_long, at_short}) {
    EXPECT_LE(100 * shares.reflected, reflected);
    EXPECT_LE(100 * shares.lost, lost);
  }
  if (ratio < 1) return;
  constexpr double kReadable = 1e-5;  // of the energy: where hardly anything is lost, 10 % of it is nothing
  EXPECT_NEAR(at_long.reflected, at_short.reflected, 0.1 * at_short.reflected + kReadable);
  EXPECT_NEAR(at_long.lost, at_short.lost, 0.1 * at_short.lost + kReadable);
}

INSTANTIATE_TEST_SUITE_P(Rows, SplitWave,
                         testing::Values(Bounds{20, 0.05, 0.2}, Bounds{10, 0.05, 0.2}, Bounds{5, 0.1, 1.5},
                                         Bounds{4, 1.2, 4.5}, Bounds{3, 65, 12}, Bounds{2, 60, 60},
                                         Bounds{1, 0.3, 100}, Bounds{0.5, 0.3, 100}),
                         [](const auto& info) { return name_of_ratio(info.param.ratio); });

}  // namespace
}  // namespace adit::wave_test
