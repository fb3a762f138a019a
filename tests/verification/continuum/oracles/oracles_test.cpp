// Requirements on the closed forms that the continuum is measured against: each satisfies the equations it
// solves, found here by differences and by integration, not by its own formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/continuum/oracles/harmonic_wave.hpp"
#include "tests/verification/continuum/oracles/kirsch.hpp"
#include "tests/verification/continuum/oracles/lamb.hpp"
#include "tests/verification/continuum/oracles/lame.hpp"
#include "tests/verification/continuum/oracles/prandtl.hpp"
#include "tests/verification/continuum/oracles/quiet_boundary.hpp"
#include "tests/verification/continuum/oracles/salencon.hpp"

namespace adit::fdm::oracle::oracles_test {
namespace {

using std::numbers::pi;

const MohrCoulombHole kHoles[] = {
    {1.0, 30e6, 0, 3.45e6, pi / 6, 0, 2.8e9, 0.21},       // FLAC's example, no dilation
    {1.0, 30e6, 0, 3.45e6, pi / 6, pi / 6, 2.8e9, 0.21},  // associated
    {3.0, 5e6, 0.3e6, 0.5e6, pi / 5, pi / 18, 0.4e9, 0.3}};

double derivative(const auto& f, double r) {
  const double h = 1e-4 * r;
  return (8 * (f(r + h) - f(r - h)) - (f(r + 2 * h) - f(r - 2 * h))) / (12 * h);
}

// ds_r/dr = (s_t - s_r)/r, on both sides of the plastic radius.
TEST(Salencon, IsInEquilibrium) {
  for (const auto& hole : kHoles) {
    const Salencon exact(hole);
    const double plastic = exact.plastic_radius();
    ASSERT_GT(plastic, 1.01 * hole.radius);
    for (const double r : {(hole.radius + plastic) / 2, 0.99 * plastic, 1.01 * plastic, 3 * plastic}) {
      const auto [radial, hoop] = exact.stress(r);
      const double slope = derivative([&](double at) { return exact.stress(at).radial; }, r);
      EXPECT_NEAR(slope, (hoop - radial) / r, 1e-9 * hole.far_pressure / r);
    }
  }
}

// The ring yields everywhere and nothing outside does; the wall carries the inner pressure, the far
// ground the far pressure, which lies between radial and hoop stress.
TEST(Salencon, YieldsUpToThePlasticRadiusOnly) {
  for (const auto& hole : kHoles) {
    const Salencon exact(hole);
    const double plastic = exact.plastic_radius();
    const auto excess = [&](double r) {  // of Mohr's circle over the envelope
      const auto [radial, hoop] = exact.stress(r);
      return (radial - hoop) / 2 + (radial + hoop) / 2 * std::sin(hole.friction_angle) -
             hole.cohesion * std::cos(hole.friction_angle);
    };
    EXPECT_NEAR(exact.stress(hole.radius).radial, -hole.inner_pressure, 1e-12 * hole.far_pressure);
    for (const double part : {0.0, 0.3, 0.7, 0.999999})
      EXPECT_NEAR(excess(hole.radius + part * (plastic - hole.radius)), 0, 1e-12 * hole.far_pressure);
    EXPECT_LT(excess(1.01 * plastic), 0);
    EXPECT_LT(excess(10 * plastic), 0);
    EXPECT_NEAR(exact.stress(1e6 * plastic).hoop, -hole.far_pressure, 1e-9 * hole.far_pressure);
    const auto [radial, hoop] = exact.stress(plastic * (1 + 1e-12));
    EXPECT_LT(hoop, -hole.far_pressure);
    EXPECT_GT(radial, -hole.far_pressure);
  }
}

// Stress and displacement do not jump at the plastic radius.
TEST(Salencon, IsContinuousAtThePlasticRadius) {
  for (const auto& hole : kHoles) {
    const Salencon exact(hole);
    const double in = exact.plastic_radius() * (1 - 1e-13), out = exact.plastic_radius();
    EXPECT_NEAR(exact.stress(in).radial, exact.stress(out).radial, 1e-11 * hole.far_pressure);
    EXPECT_NEAR(exact.stress(in).hoop, exact.stress(out).hoop, 1e-11 * hole.far_pressure);
    EXPECT_NEAR(exact.displacement(in) / exact.displacement(out), 1, 1e-11);
  }
}

// The wall's displacement is the flow rule integrated step by step (Runge and Kutta) inwards from the elastic
// ground: du/dr + K' u/r = e_r + K' e_t of the elastic strains.
TEST(Salencon, DisplacementIntegratesTheFlowRule) {
  for (const auto& hole : kHoles) {
    const Salencon exact(hole);
    const double k = (1 + std::sin(hole.dilation_angle)) / (1 - std::sin(hole.dilation_angle));
    const double nu = hole.poisson;
    const auto slope = [&](double r, double u) {
      const double radial = exact.stress(r).radial + hole.far_pressure;
      const double hoop = exact.stress(r).hoop + hole.far_pressure;
      const double elastic = (1 - nu) * radial - nu * hoop + k * ((1 - nu) * hoop - nu * radial);
      return elastic / (2 * hole.shear_modulus) - k * u / r;
    };
    const double plastic = exact.plastic_radius();
    const auto outside = [&](double r) { return exact.displacement(r); };
    const double hoop_strain = ((1 - nu) * (exact.stress(2 * plastic).hoop + hole.far_pressure) -
                                nu * (exact.stress(2 * plastic).radial + hole.far_pressure)) /
                               (2 * hole.shear_modulus);
    EXPECT_NEAR(outside(2 * plastic) / (2 * plastic) / hoop_strain, 1, 1e-12);
    const int steps = 2000;
    const double h = (hole.radius - plastic) / steps;
    double u = outside(plastic);
    for (int i = 0; i < steps; ++i) {
      const double r = plastic + i * h, inside = r * (1 - 1e-14);
      const double k1 = slope(inside, u), k2 = slope(r + h / 2, u + h / 2 * k1);
      const double k3 = slope(r + h / 2, u + h / 2 * k2), k4 = slope(r + h, u + h * k3);
      u += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    EXPECT_NEAR(exact.displacement(hole.radius) / u, 1, 1e-9);
  }
}

// The fan joins the free surface to the footing's pressure: at its edges it carries what the wedges carry,
// and all of it yields.
TEST(Prandtl, FanJoinsTheFreeSurfaceToTheFooting) {
  const double c = 20e3;
  const auto cartesian = [&](double angle, double along, double down) {  // traction normal to (along, down)
    const auto [mean, shear] = prandtl_fan(c, angle);
    const double r = along * std::cos(angle) + down * std::sin(angle);
    const double t = -along * std::sin(angle) + down * std::cos(angle);
    return mean + 2 * r * t * shear;
  };
  EXPECT_NEAR(cartesian(pi / 4, 0, 1), 0, 1e-9 * c);
  EXPECT_NEAR(cartesian(pi / 4, 1, 0), -2 * c, 1e-9 * c);
  EXPECT_NEAR(cartesian(3 * pi / 4, 0, 1), -prandtl_pressure(c), 1e-9 * c);
  const double slope = (prandtl_fan(c, 1.5).mean - prandtl_fan(c, 1.4).mean) / 0.1;
  EXPECT_NEAR(slope, -2 * prandtl_fan(c, 1.45).shear, 1e-9 * c);  // equilibrium in rotation
}

const CartesianStress kFar{-3e6, -1e6, 0.7e6};

// The wall carries no traction, whatever the far stress; far away the stress is the far stress. Uniaxial
// stress gives the factors 3 and -1.
TEST(Kirsch, HasAFreeWallAndTheFarStress) {
  const Kirsch exact(2, kFar, 1e9, 0.3);
  for (int i = 0; i < 12; ++i) {
    const double c = std::cos(0.1 + i * pi / 6), s = std::sin(0.1 + i * pi / 6);
    const auto [xx, yy, xy] = exact.stress(2 * c, 2 * s);
    EXPECT_NEAR(xx * c + xy * s, 0, 1e-9 * 3e6);
    EXPECT_NEAR(xy * c + yy * s, 0, 1e-9 * 3e6);
    const auto far = exact.stress(2e6 * c, 2e6 * s);
    EXPECT_NEAR(far.xx, kFar.xx, 1e-9 * 3e6);
    EXPECT_NEAR(far.yy, kFar.yy, 1e-9 * 3e6);
    EXPECT_NEAR(far.xy, kFar.xy, 1e-9 * 3e6);
  }
  const Kirsch uniaxial(1, {1, 0, 0}, 1, 0.3);
  EXPECT_NEAR(uniaxial.stress(0, 1).xx, 3, 1e-12);
  EXPECT_NEAR(uniaxial.stress(1, 0).yy, -1, 1e-12);
}

// The displacements strain to the stresses by Hooke's law in plane strain, and the stresses are in
// equilibrium.
TEST(Kirsch, DisplacementAndStressBelongTogether) {
  const double g = 1e9, nu = 0.3, h = 1e-3;
  const Kirsch exact(2, kFar, g, nu);
  for (const auto& [x, y] : {std::pair{2.5, 0.4}, {-1.0, 2.2}, {3.0, -5.0}}) {
    const auto ux = (exact.displacement(x + h, y) - exact.displacement(x - h, y)) / (2 * h);
    const auto uy = (exact.displacement(x, y + h) - exact.displacement(x, y - h)) / (2 * h);
    const double dilation = (ux.real() + uy.imag()) * 2 * g * nu / (1 - 2 * nu);
    const auto s = exact.stress(x, y);
    EXPECT_NEAR(s.xx, dilation + 2 * g * ux.real(), 1e-6 * 3e6);
    EXPECT_NEAR(s.yy, dilation + 2 * g * uy.imag(), 1e-6 * 3e6);
    EXPECT_NEAR(s.xy, g * (uy.real() + ux.imag()), 1e-6 * 3e6);
    const auto right = exact.stress(x + h, y), left = exact.stress(x - h, y);
    const auto above = exact.stress(x, y + h), below = exact.stress(x, y - h);
    EXPECT_NEAR((right.xx - left.xx + above.xy - below.xy) / (2 * h), 0, 1e-6 * 3e6);
    EXPECT_NEAR((right.xy - left.xy + above.yy - below.yy) / (2 * h), 0, 1e-6 * 3e6);
  }
}

// Both walls carry their pressures; equilibrium; Hooke's law in plane strain.
TEST(Lame, CarriesBothPressures) {
  const double g = 1e9, nu = 0.25;
  const LameCylinder exact(1, 3, 2e6, 5e6, g, nu);
  EXPECT_NEAR(exact.stress(1).radial, -2e6, 1e-6);
  EXPECT_NEAR(exact.stress(3).radial, -5e6, 1e-6);
  for (const double r : {1.1, 2.0, 2.9}) {
    const auto [radial, hoop] = exact.stress(r);
    EXPECT_NEAR(derivative([&](double at) { return exact.stress(at).radial; }, r), (hoop - radial) / r, 1);
    const double e_r = derivative([&](double at) { return exact.displacement(at); }, r);
    const double e_t = exact.displacement(r) / r;
    EXPECT_NEAR(radial, 2 * g * ((1 - nu) * e_r + nu * e_t) / (1 - 2 * nu), 1);
    EXPECT_NEAR(hoop, 2 * g * ((1 - nu) * e_t + nu * e_r) / (1 - 2 * nu), 1);
  }
}

const Medium kMedium{plane_strain(1e9, 0.3), 2000};
const HarmonicWave kWaves[] = {p_wave(kMedium, 0.9, 0.5), sv_wave(kMedium, 0.7, 1.1),
                               rayleigh_wave(kMedium, 0.8)};

// rho u'' = div sigma, Hooke's law and v = u', by differences.
TEST(HarmonicWave, SolvesTheEquationOfMotion) {
  const double h = 1e-4, x = 0.3, y = -0.2;
  for (const auto& wave : kWaves) {
    const double w = wave.omega(), t = 1.1 / w, scale = w * w * kMedium.density;
    const auto force = [&](std::size_t axis) {
      const auto right = wave.stress(x + h, y, t), left = wave.stress(x - h, y, t);
      const auto above = wave.stress(x, y + h, t), below = wave.stress(x, y - h, t);
      return axis == 0 ? (right.xx - left.xx + above.xy - below.xy) / (2 * h)
                       : (right.xy - left.xy + above.yy - below.yy) / (2 * h);
    };
    const auto gradient = [&](std::size_t axis, double dx, double dy) {
      return (wave.displacement(x + dx, y + dy, t)[axis] - wave.displacement(x - dx, y - dy, t)[axis]) /
             (2 * h);
    };
    for (const std::size_t axis : {0, 1}) {
      EXPECT_NEAR(force(axis), -scale * wave.displacement(x, y, t)[axis], 1e-6 * scale);
      const double rate =
          (wave.displacement(x, y, t + h / w)[axis] - wave.displacement(x, y, t - h / w)[axis]) * w / (2 * h);
      EXPECT_NEAR(wave.velocity(x, y, t)[axis], rate, 1e-6 * w);
    }
    const double exx = gradient(0, h, 0), eyy = gradient(1, 0, h),
                 gxy = gradient(0, 0, h) + gradient(1, h, 0);
    const Stress stress = wave.stress(x, y, t);
    EXPECT_NEAR(stress.xx + stress.yy, 2 * kMedium.law.bulk * (exx + eyy), 1e-5 * kMedium.law.bulk);
    EXPECT_NEAR(stress.xx - stress.yy, 2 * kMedium.law.shear * (exx - eyy), 1e-5 * kMedium.law.bulk);
    EXPECT_NEAR(stress.xy, kMedium.law.shear * gxy, 1e-5 * kMedium.law.bulk);
  }
}

// The surface is free and the depth at rest; for nu = 0.25 the speed is sqrt(2 - 2/sqrt(3)) c_S, its closed
// form.
TEST(RayleighWave, LeavesTheSurfaceFree) {
  const double scale = kMedium.law.bulk / 0.8;
  for (const double x : {0.0, 0.13, 0.5}) {
    EXPECT_NEAR(kWaves[2].stress(x, 0, 1e-4).yy, 0, 1e-11 * scale);
    EXPECT_NEAR(kWaves[2].stress(x, 0, 1e-4).xy, 0, 1e-11 * scale);
    EXPECT_NEAR(kWaves[2].displacement(x, -8, 1e-4)[0], 0, 1e-9);
  }
  const Medium quarter{plane_strain(1e9, 0.25), 2000};
  EXPECT_NEAR(rayleigh_speed(quarter) / quarter.s_speed(), std::sqrt(2 - 2 / std::sqrt(3)), 1e-12);
}

// A pulse of the area 1 s, after which no load is left.
struct Pulse {
  double width, peak;
  Complex operator()(Complex t) const {
    const Complex a = (t - peak) / width;
    return std::exp(-a * a) / (width * std::sqrt(pi));
  }
  double reach() const { return 6 * width; }
};

// Nothing moves before the fastest wave arrives.
TEST(Lamb, IsCausal) {
  const Ricker source{10, 0.5};
  const double x = 1000, first = x / kMedium.p_speed() + source.peak - 0.95 * source.reach();
  const double later = first + 1.2 * source.reach();
  EXPECT_NEAR(lamb(kMedium, 1e6, source, x, first)[0], 0,
              1e-6 * std::abs(lamb(kMedium, 1e6, source, x, later)[0]));
  EXPECT_NEAR(lamb(kMedium, 1e6, source, x, first)[1], 0,
              1e-6 * std::abs(lamb(kMedium, 1e6, source, x, later)[1]));
}

// The sum over time of the response to a pulse is the static displacement under the load (Flamant 1892):
// u_x = -(1 - 2 nu) P/(4 mu) everywhere, u_y(x1) - u_y(x2) = -(1 - nu) P/(pi mu) log(x2/x1).
TEST(Lamb, SumsUpToFlamantsStatics) {
  const Pulse pulse{0.1, 0.7};
  const double dt = 0.05, nu = 0.3, force = 1e6, mu = kMedium.law.shear;
  Vector near{}, far{};
  for (double t = 0; t < 20; t += dt) {
    const auto a = lamb(kMedium, force, pulse, 200, t), b = lamb(kMedium, force, pulse, 400, t);
    for (const std::size_t axis : {0, 1}) {
      near[axis] += dt * a[axis];
      far[axis] += dt * b[axis];
    }
  }
  EXPECT_NEAR(near[0], -(1 - 2 * nu) * force / (4 * mu), 1e-3 * force / mu);
  EXPECT_NEAR(far[0], near[0], 1e-3 * force / mu);
  EXPECT_NEAR(near[1] - far[1], -(1 - nu) * force / (pi * mu) * std::log(2.0), 1e-3 * force / mu);
}

// The boundary's stress is that of the dashpots; what they take up is what does not return: the mean power of
// the incident wave's flux and of the dashpots agree.
TEST(ViscousReflection, SatisfiesTheDashpotsAndKeepsEnergy) {
  const double omega = 100, cp = kMedium.p_speed(), cs = kMedium.s_speed(), rho = kMedium.density;
  for (const auto incident : {Incident::kP, Incident::kSv})
    for (const double angle : {0.0, 0.4, 0.8, 1.2, 1.5}) {
      const auto [wave, returned] = viscous_reflection(kMedium, incident, angle, omega);
      const double period = 2 * pi / omega;
      constexpr int kInstants = 16;
      double taken = 0;
      for (int n = 0; n < kInstants; ++n) {
        const double t = period * n / kInstants;
        const Stress stress = wave.stress(0, 0.7, t);
        const Vector v = wave.velocity(0, 0.7, t);
        EXPECT_NEAR(stress.xx, -rho * cp * v[0], 1e-9 * rho * cp * omega);
        EXPECT_NEAR(stress.xy, -rho * cs * v[1], 1e-9 * rho * cp * omega);
        taken -= (stress.xx * v[0] + stress.xy * v[1]) / kInstants;
      }
      const double flux = rho * omega * omega / 2 * (incident == Incident::kP ? cp : cs) * std::cos(angle);
      EXPECT_NEAR(taken / flux, 1 - returned, 1e-9);
    }
}

// Head-on nothing returns, at most 1 % of a P wave to 30 degrees and of an SV wave to 20, and everything
// along the boundary.
TEST(ViscousReflection, GrowsFromNothingToEverything) {
  const auto returned = [](Incident incident, double degrees) {
    return viscous_reflection(kMedium, incident, degrees * pi / 180, 100).returned_energy;
  };
  for (const auto incident : {Incident::kP, Incident::kSv}) {
    EXPECT_NEAR(returned(incident, 0), 0, 1e-12);
    EXPECT_GE(returned(incident, 89.9), 0.98);
  }
  EXPECT_LE(returned(Incident::kP, 30), 0.01);
  EXPECT_LE(returned(Incident::kSv, 20), 0.01);
}

}  // namespace
}  // namespace adit::fdm::oracle::oracles_test
