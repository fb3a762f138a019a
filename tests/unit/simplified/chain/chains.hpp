// Chains that the tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "simplified/chain/simulation.hpp"

namespace adit::simplified::chain::test {

// A segment of an immersed tunnel, 22.5 m and 9500 t, on nothing.
inline Body segment() {
  Body body;
  body.length = 22.5;
  body.mass = 9.5e6;
  body.inertia = 1.5e9;
  return body;
}

// An immersion joint of 2 GN/m.
inline Hinge joint() {
  Hinge hinge;
  hinge.axial.stiffness = 2e9;
  hinge.shear.stiffness = 5e10;
  hinge.rotation.stiffness = 5e12;
  return hinge;
}

inline Chain segments(std::size_t n) {
  return {std::vector<Body>(n, segment()), std::vector<Hinge>(n - 1, joint()), {}, {}};
}

// A tunnel that winds, with sections, hinges and strata that vary from body to body: fixed at its start by a
// hinge, free at its finish.
inline Chain winding(std::size_t n) {
  Chain chain = segments(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i);
    Body& body = chain.bodies[i];
    body.angle = 0.5 * std::sin(0.01 * s) + 0.3;
    body.length = 22.5 * (1 + 0.3 * std::sin(0.7 * s));
    body.mass *= 1 + 0.5 * std::sin(1.3 * s);
    body.ground_stiffness = {3e8 * (1.1 + std::sin(0.05 * s)), 5e8 * (1.1 + std::cos(0.03 * s)), 4e10};
    body.ground_dashpot = {4e7, 5e7 * (1.2 + std::sin(0.4 * s)), 1e9};
  }
  for (std::size_t j = 0; j + 1 < n; ++j) {
    const double factor = std::pow(10.0, std::sin(0.9 * static_cast<double>(j)));
    Hinge& hinge = chain.hinges[j];
    for (HingeDirection* d : {&hinge.axial, &hinge.shear, &hinge.rotation}) {
      d->stiffness *= factor;
      d->dashpot = 0.002 * d->stiffness;
    }
  }
  chain.start = joint();
  return chain;
}

// Ground motion of three frequencies, running along the chain and different in x and y.
class Wave {
 public:
  explicit Wave(std::size_t n) : x_(n), y_(n), vx_(n), vy_(n) {}
  Excitation at(double t) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double s = t - 0.01 * static_cast<double>(i);
      x_[i] = y_[i] = vx_[i] = vy_[i] = 0;
      if (s <= 0) continue;
      for (const double omega : {2.0, 7.0, 31.0}) {
        x_[i] += 0.1 / omega * (1 - std::cos(omega * s));
        vx_[i] += 0.1 * std::sin(omega * s);
      }
      y_[i] = 0.5 * x_[i];
      vy_[i] = 0.5 * vx_[i];
    }
    return {.ground_x = x_, .ground_y = y_, .ground_vx = vx_, .ground_vy = vy_};
  }

 private:
  std::vector<double> x_, y_, vx_, vy_;
};

// Newmark with as much dissipation as it can have and a long step goes to the state of rest under constant
// loads.
inline constexpr Newmark kSettling{0.5625, 1.0};

}  // namespace adit::simplified::chain::test
