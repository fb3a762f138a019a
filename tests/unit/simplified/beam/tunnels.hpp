// Tunnels that the tests share.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "simplified/beam/run.hpp"

namespace adit::simplified::beam {

inline constexpr double kPi = std::numbers::pi;

// The worked uniform case of an immersed tunnel: a concrete tube 37.95 m wide in soft soil.
inline constexpr double kYoung = 34.5e9, kArea = 165, kInertia = 2.2e4, kWidth = 37.95;

inline Tunnel immersed_tube(double from, double to, double element_length, double soil_stiffness) {
  Tunnel tunnel;
  Section section;
  section.from = from;
  section.to = to;
  section.youngs_modulus = kYoung;
  section.area = kArea;
  section.inertia_lateral = kInertia;
  section.inertia_vertical = 2.5e3;
  section.mass = 4.3e5;
  section.half_width = kWidth / 2;
  section.half_height = 5.7;
  tunnel.sections = {section};
  SoilSpring spring;
  spring.stiffness = soil_stiffness;
  tunnel.soil = {{from, {spring, spring, spring}}, {to, {spring, spring, spring}}};
  tunnel.element_length = element_length;
  return tunnel;
}

// Ground that lies displaced by shape(x) in one direction, at rest.
inline GroundMotion displaced(Direction direction, std::function<double(double)> shape) {
  return [=](double, std::span<const double> chainages, GroundState& state) {
    still()(0, chainages, state);
    for (std::size_t i = 0; i < chainages.size(); ++i) state.displacement[direction][i] = shape(chainages[i]);
  };
}

// Ground that moves by u(t, x) with speed v(t, x).
inline GroundMotion moving(Direction direction, std::function<double(double, double)> u,
                           std::function<double(double, double)> v) {
  return [=](double t, std::span<const double> chainages, GroundState& state) {
    still()(0, chainages, state);
    for (std::size_t i = 0; i < chainages.size(); ++i) {
      state.displacement[direction][i] = u(t, chainages[i]);
      state.velocity[direction][i] = v(t, chainages[i]);
    }
  };
}

// Only the static state.
inline RunOptions statics() {
  RunOptions options;
  options.dt = 1;
  options.field_every = 1;
  return options;
}

inline std::size_t nearest_place(const std::vector<double>& chainages, double x) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < chainages.size(); ++i)
    if (std::abs(chainages[i] - x) < std::abs(chainages[best] - x)) best = i;
  return best;
}

}  // namespace adit::simplified::beam
