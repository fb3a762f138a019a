// Plane waves that meet a quiet boundary at any angle: what theory sends back, and what the grid does.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "fdm_server/boundaries/edge_set.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"

namespace adit::fdm::test {

enum class Wave { kPressure, kShear };

struct Medium {
  double bulk, shear, density;  // kappa and mu of plane_law.hpp
  double cp() const { return std::sqrt((bulk + shear) / density); }
  double cs() const { return std::sqrt(shear / density); }
  double speed(Wave wave) const { return wave == Wave::kPressure ? cp() : cs(); }
};

// Share of the energy that comes back from dashpots below the half-space y > 0, of a wave that comes down at
// `angle` from the vertical.
//
// With the factor exp(i (kx x - w t)), displacements are d exp(-i q y) of the incident wave, and of the
// reflected ones a d exp(i q y), q^2 = k^2 - kx^2. Dashpots below: sxy = rho cs vx, syy = rho cp vy. Energy
// flows up as rho w^2/2 c cos(angle) |a|^2, and not at all where q is imaginary.
inline double reflected_in_theory(const Medium& medium, Wave wave, double angle) {
  using Complex = std::complex<double>;
  const Complex i(0, 1);
  const double cp = medium.cp(), cs = medium.cs(), kp = 1 / cp, ks = 1 / cs;  // w = 1
  const double kx = std::sin(angle) / medium.speed(wave);
  const Complex qp = std::sqrt(Complex(kp * kp - kx * kx)), qs = std::sqrt(Complex(ks * ks - kx * kx));
  struct Field {
    Complex dx, dy, ky;
  };
  const auto residual = [&](const Field& f) -> Eigen::Vector2cd {
    const Complex exx = i * kx * f.dx, eyy = i * f.ky * f.dy, shear = i * (kx * f.dy + f.ky * f.dx);
    const Complex sxy = medium.shear * shear;
    const Complex syy = medium.bulk * (exx + eyy) - medium.shear * (exx - eyy);
    return {sxy + i * medium.density * cs * f.dx, syy + i * medium.density * cp * f.dy};
  };
  const Field incident =
      wave == Wave::kPressure ? Field{kx / kp, -qp / kp, -qp} : Field{qs / ks, kx / ks, -qs};
  Eigen::Matrix2cd both;
  both << residual({kx / kp, qp / kp, qp}), residual({-qs / ks, kx / ks, qs});
  const Eigen::Vector2cd a = both.fullPivLu().solve(-residual(incident));
  const double flux = std::norm(a[0]) * cp * (qp / kp).real() + std::norm(a[1]) * cs * (qs / ks).real();
  return flux / (medium.speed(wave) * std::cos(angle));
}

// A strip of square zones that goes on for ever to both sides: its right neighbour is itself.
inline Grid periodic_strip(std::uint32_t columns, std::uint32_t rows, double h) {
  Grid grid;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      grid.x.push_back(i * h);
      grid.y.push_back(j * h);
    }
  const auto zone = [&](std::uint32_t i, std::uint32_t j) {
    const auto at = [&](std::uint32_t c, std::uint32_t r) {
      return static_cast<std::int32_t>(r * columns + c % columns);
    };
    grid.zones.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  };
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i + 1 < columns; ++i) zone(i, j);
  for (std::uint32_t j = 0; j < rows; ++j) {
    zone(columns - 1, j);
    const double left = (columns - 1) * h, right = columns * h, low = j * h, high = (j + 1) * h;
    grid.own_corners.push_back({{left, right, right, left}, {low, low, high, high}});
  }
  return grid;
}

// A packet of plane waves of one horizontal wavelength, Gaussian along y: exact solutions summed.
struct Packet {
  Medium medium;
  Wave wave;
  double kx, ky, centre, deviation;  // of the middle wave; of the envelope [m]

  // Velocity and stress at a place and time.
  struct State {
    double vx = 0, vy = 0;
    Stress stress{};
  };
  State at(double x, double y, double t) const {
    constexpr int kModes = 60;
    State sum;
    for (int m = -kModes; m <= kModes; ++m) {
      const double off = 3.5 * m / kModes;  // standard deviations of the wave number
      const double q = ky + off / deviation, k = std::hypot(kx, q), w = k * medium.speed(wave);
      if (q <= 0) continue;
      const double dx = wave == Wave::kPressure ? kx / k : q / k,
                   dy = wave == Wave::kPressure ? -q / k : kx / k;
      const double weight = std::exp(-off * off / 2), phase = kx * x - q * (y - centre) - w * t;
      const double rise = -weight * std::sin(phase);  // of Re exp(i phase), per unit of phase
      const double exx = kx * dx * rise, eyy = -q * dy * rise, shear = (kx * dy - q * dx) * rise;
      sum.vx -= w * dx * rise;
      sum.vy -= w * dy * rise;
      const double mean = medium.bulk * (exx + eyy), deviator = medium.shear * (exx - eyy);
      sum.stress.xx += mean + deviator;
      sum.stress.yy += mean - deviator;
      sum.stress.xy += medium.shear * shear;
    }
    return sum;
  }
};

struct Sampling {
  double zones_per_wavelength = 20;
  double wavelengths = 2;  // in a standard deviation of the packet, along y
  double dt_factor = 0.5;
};

// The same share, measured: the energy that a strip on dashpots holds after the packet has met them, over
// that before.
inline double reflected_by_the_grid(ZoneKind kind, const Medium& medium, Wave wave, double angle,
                                    const Sampling& sampling) {
  const double wavelength = 1, c = medium.speed(wave), h0 = wavelength / sampling.zones_per_wavelength;
  const double k = 2 * std::numbers::pi / wavelength, sine = std::sin(angle), cosine = std::cos(angle);
  const auto columns = sine == 0 ? 2u : static_cast<std::uint32_t>(std::round(wavelength / sine / h0));
  const double h = sine == 0 ? h0 : wavelength / sine / columns;
  const double deviation = sampling.wavelengths * wavelength / cosine, reach = 3.5 * deviation;
  const double duration = 1.4 * 2 * reach / (c * cosine);
  // what is reflected must not have come down again: P waves at the same horizontal wavelength are the
  // fastest
  const double p_sine = std::min(1.0, sine * medium.cp() / c);
  const double climb = medium.cp() * std::sqrt(1 - p_sine * p_sine) * duration / 2;
  const auto rows = static_cast<std::uint32_t>(std::ceil(1.05 * std::max(2 * reach, climb) / h));

  const Grid grid = periodic_strip(columns, rows, h);
  const std::vector<double> weights(grid.zones.size(), 1.0);
  const PlaneLaw law{medium.bulk, medium.shear};
  const double dt = sampling.dt_factor * critical_step(kind, grid, law, medium.density);
  const Packet packet{medium, wave, k * sine, k * cosine, reach, deviation};
  auto zones = make_zones(kind, grid, law, weights);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Corners at = corners(grid, z);
    zones->set_stress(z, packet.at((at.x[0] + at.x[1]) / 2, (at.y[0] + at.y[2]) / 2, 0).stress);
  }
  Continuum continuum(std::move(zones), lumped_masses(grid, weights, medium.density), {}, {});
  std::vector<Dashpot> dashpots;
  const Symmetric per_metre = fdm::dashpots({0, 0, 0, h, 0, -1}, impedance(law, medium.density, 1));
  for (std::uint32_t i = 0; i < columns; ++i)
    dashpots.push_back({.point = i, .damping = {h * per_metre.xx, h * per_metre.xy, h * per_metre.yy}});
  continuum.set_dashpots(std::move(dashpots), false);

  continuum.step({0, dt});
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const auto state = packet.at(grid.x[i], grid.y[i], dt / 2);
    continuum.vx()[i] = state.vx;
    continuum.vy()[i] = state.vy;
  }
  Energies first{}, last{};
  continuum.step({1, dt}, &first);
  const auto steps = static_cast<std::uint64_t>(std::ceil(duration / dt));
  for (std::uint64_t n = 2; n < steps; ++n) continuum.step({n, dt});
  continuum.step({steps, dt}, &last);
  return (last.kinetic + last.strain) / (first.kinetic + first.strain);
}

}  // namespace adit::fdm::test
