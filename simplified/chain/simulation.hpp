// Computes the motion of a chain in implicit steps of fixed length, each in O(n) and without allocating
// memory.
//
//   Simulation run(chain, {.dt = 0.005});
//   while (…) { …fill the ground motions of the next instant…; run.step({.ground_x = ux, .ground_vx = vx}); }
//   run.joints().axial.deformation[j], run.envelopes().axial_force.max[j], …
//
// Bodies are numbered i = 0 … n - 1. Joint j = 0 … n lies before body j: 0 and n are the ends, 1 … n - 1 the
// hinges. A free end carries no force; its deformation is the motion of the end relative to the ground there.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "simplified/chain/envelopes.hpp"
#include "simplified/chain/joints/integrator.hpp"
#include "simplified/chain/model/chain.hpp"

namespace adit::simplified::chain {

struct Settings {
  double dt = 0;  // [s]
  Newmark newmark = {};
  // Curves are linearized again within the step until no joint's force deviates from its curve by more than
  // this share of the curve's largest force.
  double tolerance = 1e-9;
  int max_iterations = 50;
};

// The excitation at one instant: one value for each body, or none if all are zero.
struct Excitation {
  std::span<const double> ground_x = {}, ground_y = {};    // displacement of the ground [m]
  std::span<const double> ground_vx = {}, ground_vy = {};  // its velocity [m/s]
  std::span<const double> load_x = {}, load_y = {};        // on the centres [N]
  std::span<const double> moment = {};                     // [N m]
};

// One value for each body, or none if all are zero.
struct InitialMotion {
  std::span<const double> x = {}, y = {}, rotation = {};  // [m], [rad]
  std::span<const double> vx = {}, vy = {}, spin = {};    // [m/s], [rad/s]
};

// The motion of the bodies' centres, in the axes of the plane.
struct BodyMotion {
  std::span<const double> x, y, rotation;                // displacement [m], [rad]
  std::span<const double> vx, vy, spin;                  // [m/s], [rad/s]
  std::span<const double> ax, ay, angular_acceleration;  // [m/s^2], [rad/s^2]
};

// One value for each joint, in the axes of the joint.
struct JointDirection {
  std::span<const double> deformation;  // opening, slip [m] or rotation [rad]
  std::span<const double> force;        // [N], [N m], including the force at rest
};
struct Joints {
  JointDirection axial, shear, rotation;
};

class Simulation {
 public:
  // At rest. Throws protocol::UserError at a field of the chain, `dt`, `integrator.…`, `tolerance`,
  // `max_iterations`.
  Simulation(const Chain& chain, const Settings& settings);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  // Replaces the state at rest, before the first step; `at_start` acts at t = 0 and gives the first
  // acceleration.
  void start(const InitialMotion& motion, const Excitation& at_start = {});

  // Makes one step; `at_end` acts at its end. Throws std::invalid_argument if a span has the wrong size, and
  // protocol::Unstable, with step and place, if a value is not finite or a curve does not converge.
  void step(const Excitation& at_end);

  long steps() const;
  double time() const;        // [s]
  long iterations() const;    // solutions of the linear equations so far; with curves more than one in a step
  BodyMotion bodies() const;  // valid until the next step, as all that follows
  Joints joints() const;
  const Envelopes& envelopes() const;  // since the start

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adit::simplified::chain
