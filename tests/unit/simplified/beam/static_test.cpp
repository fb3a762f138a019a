// Static closed forms of a tube on springs (St John & Zahrah): u = u_g/(1 + EA q²/K), w = w_g/(1 + EI q⁴/K).
#include <gtest/gtest.h>

#include "tests/unit/simplified/beam/tunnels.hpp"

namespace adit::simplified::beam::static_test {
namespace {

constexpr double kSoil = 1.661e8, kLength = 400, kAmplitude = 0.05, kQ = 2 * kPi / kLength;

// Largest relative error of axial displacement and force: between free ends a quarter wave from the middle
// the closed form holds exactly.
double axial_error(int elements) {
  const Tunnel tunnel = immersed_tube(-kLength / 4, kLength / 4, kLength / 2 / elements, kSoil);
  const Results results =
      run(tunnel, displaced(kAxial, [](double x) { return kAmplitude * std::sin(kQ * x); }), statics());
  const double amplitude = kAmplitude / (1 + kYoung * kArea * kQ * kQ / kSoil);
  const Record& field = results.fields.front();
  double largest = 0;
  for (std::size_t e = 0; e < results.chainage.size(); ++e) {
    const double u = field.displacement[kAxial][e], exact = amplitude * std::sin(kQ * results.chainage[e]);
    largest = std::max(largest, std::abs(u - exact) / amplitude);
    const double expected = kYoung * kArea * amplitude * kQ * std::cos(kQ * results.chainage[e]);
    largest =
        std::max(largest, std::abs(field.axial_force[e] - expected) / (kYoung * kArea * amplitude * kQ));
  }
  return largest;
}

TEST(StaticTube, AxialDisplacementAndForceMeetTheClosedFormAtOrderTwo) {
  double previous = axial_error(16);
  for (const int elements : {32, 64, 128}) {
    const double error = axial_error(elements);
    EXPECT_NEAR(std::log2(previous / error), 2, 0.05) << elements;
    previous = error;
  }
  EXPECT_LT(axial_error(2048), 1e-6);
}

// The middle wave of seven: what the free ends disturb has died away there.
double error_of_middle_wave(const Tunnel& tunnel, Direction direction, double amplitude) {
  const Results results =
      run(tunnel, displaced(direction, [](double x) { return kAmplitude * std::sin(kQ * x); }), statics());
  double largest = 0;
  for (std::size_t e = 0; e < results.chainage.size(); ++e) {
    const double x = results.chainage[e];
    if (std::abs(x) > kLength / 2) continue;
    const double w = results.fields.front().displacement[direction][e];
    largest = std::max(largest, std::abs(w - amplitude * std::sin(kQ * x)) / amplitude);
  }
  return largest;
}

double bending_error(Direction direction, double inertia, double element_length) {
  const double amplitude = kAmplitude / (1 + kYoung * inertia * std::pow(kQ, 4) / kSoil);
  return error_of_middle_wave(immersed_tube(-3.5 * kLength, 3.5 * kLength, element_length, kSoil), direction,
                              amplitude);
}

TEST(StaticTube, BendingMeetsTheClosedFormAtOrderFourInBothPlanes) {
  for (const auto& [direction, inertia] : {std::pair{kLateral, kInertia}, {kVertical, 2.5e3}}) {
    double previous = bending_error(direction, inertia, 50);
    for (const double length : {25., 12.5}) {
      const double error = bending_error(direction, inertia, length);
      EXPECT_NEAR(std::log2(previous / error), 4, 0.25) << length;
      previous = error;
    }
    EXPECT_LT(bending_error(direction, inertia, 5), 1e-6);
  }
}

double bending_with_shear_error(double element_length) {
  Tunnel tunnel = immersed_tube(-3.5 * kLength, 3.5 * kLength, element_length, kSoil);
  tunnel.sections[0].shear_modulus = kYoung / 2.4;
  tunnel.sections[0].shear_area_lateral = 60;
  const double rigidity = kYoung * kInertia, shear = kYoung / 2.4 * 60;
  const double amplitude =
      kAmplitude / (1 + rigidity * std::pow(kQ, 4) / (1 + rigidity * kQ * kQ / shear) / kSoil);
  return error_of_middle_wave(tunnel, kLateral, amplitude);
}

// With shear: w = w_g/(1 + EI q⁴/(1 + EI q²/GA)/K). Short elements shear more than they bend: order two.
TEST(StaticTube, BendingWithShearMeetsTheClosedFormAtOrderTwo) {
  double previous = bending_with_shear_error(10);
  for (const double length : {5., 2.5}) {
    const double error = bending_with_shear_error(length);
    EXPECT_NEAR(std::log2(previous / error), 2, 0.1) << length;
    previous = error;
  }
  EXPECT_LT(bending_with_shear_error(0.4), 1e-6);
}

// The worked uniform case of an immersed tunnel: K = 16πG(1−ν)/(3−4ν)·d/L, axial strain of a wave at 45°, N
// and bending strain, to the digits they are known to.
TEST(StaticTube, WorkedUniformCase) {
  const double shear_modulus = 1900 * 200. * 200, nu = 0.45;
  const double soil = 16 * kPi * shear_modulus * (1 - nu) / (3 - 4 * nu) * kWidth / kLength;
  EXPECT_NEAR(soil, 1.661e8, 0.0005e8);

  // At 45° the wave is √2 longer along the axis and 1/√2 of its amplitude lies along it.
  const double q = kQ / std::sqrt(2.), quarter = kPi / 2 / q;
  const Results axial = run(
      immersed_tube(-quarter, quarter, 1, soil),
      displaced(kAxial, [=](double x) { return kAmplitude / std::sqrt(2.) * std::sin(q * x); }), statics());
  const std::size_t middle = nearest_place(axial.chainage, 0);
  EXPECT_NEAR(axial.axial_force.maximum[middle], 428e6, 0.5e6);
  EXPECT_NEAR(axial.strain.maximum[middle], 7.51e-5, 0.005e-5);

  const Results bending =
      run(immersed_tube(-3.5 * kLength, 3.5 * kLength, 2, soil),
          displaced(kLateral, [](double x) { return kAmplitude * std::sin(kQ * x); }), statics());
  EXPECT_NEAR(bending.strain.maximum[nearest_place(bending.chainage, kLength / 4)], 1.83e-4, 0.005e-4);
}

// Elastic joints every l soften the tube as 1/EA_eff = 1/EA + 1/(k l).
TEST(StaticTube, JointsInSeriesSoftenTheTube) {
  const double spacing = 22.5, stiffness = 5e9, strain = 1e-4;
  Tunnel tunnel = immersed_tube(0, 8 * spacing, spacing / 2, 1e2);
  tunnel.start = tunnel.end = Portal::kFixed;
  for (int i = 0; i < 8; ++i) {
    Joint joint;
    joint.chainage = (i + 0.5) * spacing;
    joint.springs = {{0, 0, linear(stiffness)}};
    tunnel.joints.push_back(joint);
  }
  const Results results = run(tunnel, displaced(kAxial, [=](double x) { return strain * x; }), statics());
  const double effective = 1 / (1 / (kYoung * kArea) + 1 / (stiffness * spacing));
  for (const double force : results.fields[0].axial_force) EXPECT_NEAR(force / (effective * strain), 1, 1e-6);
}

// Where the section changes, forces in series stay the same and strains follow the stiffness.
TEST(StaticTube, SectionsThatVaryShareOneForce) {
  Tunnel tunnel = immersed_tube(0, 100, 10, 1e2);
  tunnel.sections[0].to = 40;
  Section bay = tunnel.sections[0];
  bay.from = 40;
  bay.to = 100;
  bay.area = 3 * kArea;
  tunnel.sections.push_back(bay);
  tunnel.start = tunnel.end = Portal::kFixed;
  const Results results = run(tunnel, displaced(kAxial, [](double x) { return 1e-4 * x; }), statics());
  const double expected = 0.01 / (40 / (kYoung * kArea) + 60 / (kYoung * 3 * kArea));
  for (const double force : results.fields[0].axial_force) EXPECT_NEAR(force / expected, 1, 1e-6);
}

// A uniform static load sinks a uniform tube by load / soil stiffness.
TEST(StaticTube, SinksUnderItsLoad) {
  Tunnel tunnel = immersed_tube(0, 200, 10, kSoil);
  tunnel.sections[0].load = {0, 0, -2e5};
  const Results results = run(tunnel, still(), statics());
  for (const double w : results.fields[0].displacement[kVertical]) EXPECT_NEAR(w / (-2e5 / kSoil), 1, 1e-9);
}

// Soil that slips with hardening h gives f_slip + h k (e − f_slip/k).
TEST(StaticTube, SoilSlipsWithHardening) {
  Tunnel tunnel = immersed_tube(0, 200, 10, kSoil);
  for (auto& station : tunnel.soil) station.springs[kAxial] = {1e7, 2e5, 0.1, 0};
  tunnel.sections[0].load = {3e5, 0, 0};
  const Results results = run(tunnel, still(), statics());
  for (const double u : results.fields[0].displacement[kAxial])
    EXPECT_NEAR(u / (2e5 / 1e7 + 1e5 / 1e6), 1, 1e-9);
}

// Stiffness that rises along the chainage: at the free-standing equilibrium a stiff tube carries the mean of
// the soil.
TEST(StaticTube, SoilVariesLinearlyBetweenStations) {
  Tunnel tunnel = immersed_tube(0, 100, 5, 0);
  for (int d = 0; d < 3; ++d) {
    tunnel.soil[0].springs[d].stiffness = 1e5;
    tunnel.soil[1].springs[d].stiffness = 3e5;
  }
  tunnel.sections[0].load = {1e3, 0, 0};
  const Results results = run(tunnel, still(), statics());
  EXPECT_NEAR(results.fields[0].displacement[kAxial][10] / (1e3 / 2e5), 1, 1e-4);
}

}  // namespace
}  // namespace adit::simplified::beam::static_test
