// Plane waves that meet a quiet boundary at any angle: what theory sends back, and what the grid does.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "fdm_server/boundaries/edge_set.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/oracles/quiet_boundary.hpp"

namespace adit::fdm::test {

using oracle::Incident;
using oracle::Medium;

inline double speed(const Medium& medium, Incident wave) {
  return wave == Incident::kP ? medium.p_speed() : medium.s_speed();
}

// Share of the energy of a wave at `angle` from the normal that dashpots send back.
inline double reflected_in_theory(const Medium& medium, Incident wave, double angle) {
  return oracle::viscous_reflection(medium, wave, angle, 1).returned_energy;
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
  Incident wave;
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
      const double q = ky + off / deviation, k = std::hypot(kx, q), w = k * speed(medium, wave);
      if (q <= 0) continue;
      const double dx = wave == Incident::kP ? kx / k : q / k, dy = wave == Incident::kP ? -q / k : kx / k;
      const double weight = std::exp(-off * off / 2), phase = kx * x - q * (y - centre) - w * t;
      const double rise = -weight * std::sin(phase);  // of Re exp(i phase), per unit of phase
      const double exx = kx * dx * rise, eyy = -q * dy * rise, shear = (kx * dy - q * dx) * rise;
      sum.vx -= w * dx * rise;
      sum.vy -= w * dy * rise;
      const double mean = medium.law.bulk * (exx + eyy), deviator = medium.law.shear * (exx - eyy);
      sum.stress.xx += mean + deviator;
      sum.stress.yy += mean - deviator;
      sum.stress.xy += medium.law.shear * shear;
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
inline double reflected_by_the_grid(ZoneKind kind, const Medium& medium, Incident wave, double angle,
                                    const Sampling& sampling) {
  const double wavelength = 1, c = speed(medium, wave), h0 = wavelength / sampling.zones_per_wavelength;
  const double k = 2 * std::numbers::pi / wavelength, sine = std::sin(angle), cosine = std::cos(angle);
  const auto columns = sine == 0 ? 2u : static_cast<std::uint32_t>(std::round(wavelength / sine / h0));
  const double h = sine == 0 ? h0 : wavelength / sine / columns;
  const double deviation = sampling.wavelengths * wavelength / cosine, reach = 3.5 * deviation;
  const double duration = 1.4 * 2 * reach / (c * cosine);
  // what is reflected must not have come down again: P waves at the same horizontal wavelength are the
  // fastest
  const double p_sine = std::min(1.0, sine * medium.p_speed() / c);
  const double climb = medium.p_speed() * std::sqrt(1 - p_sine * p_sine) * duration / 2;
  const auto rows = static_cast<std::uint32_t>(std::ceil(1.05 * std::max(2 * reach, climb) / h));

  const Grid grid = periodic_strip(columns, rows, h);
  const std::vector<double> weights(grid.zones.size(), 1.0);
  const double dt = sampling.dt_factor * critical_step(kind, grid, medium.law, medium.density);
  const Packet packet{medium, wave, k * sine, k * cosine, reach, deviation};
  ZoneSet zones(kind, grid, medium.law, weights);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Corners at = corners(grid, z);
    zones.set_stress(z, packet.at((at.x[0] + at.x[1]) / 2, (at.y[0] + at.y[2]) / 2, 0).stress);
  }
  Continuum continuum(std::move(zones), lumped_masses(grid, weights, medium.density), {}, {});
  std::vector<Dashpot> dashpots;
  const Symmetric per_metre = fdm::dashpots({0, 0, 0, h, 0, -1}, impedance(medium.law, medium.density, 1));
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
