// The particles that a run computes with: structure of arrays, no gaps.
//
// Places at rest stay, displacements move: a bond's strain then keeps all its digits wherever the model lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "protocol/state/archive.hpp"

namespace adit::dem {

struct Model;

struct Particles {
  std::vector<std::uint32_t> id;             // place in the packing
  std::vector<double> x, y;                  // centre at rest [m]
  std::vector<double> radius;                // [m]
  std::vector<double> ux, uy;                // displacement [m]
  std::vector<double> settled_x, settled_y;  // of it by statics, before time began [m]
  std::vector<double> vx, vy, spin;          // velocity [m/s], [rad/s]
  std::vector<double> fx, fy, moment;        // resultants of this step [N], [N m]
  std::vector<double> weight;                // energy weight, in mass and inertia already
  std::vector<double> mass, inertia;         // weighted [kg], [kg m^2]
  // Of the masses that are moved, which are others where statics scale them [1/kg], [1/(kg m^2)].
  std::vector<double> inverse_mass, inverse_inertia;
  std::vector<double> tie_x,
      tie_y;  // forces of the multipliers at the last step where statics damp [N]; else empty
  std::size_t size() const { return id.size(); }
  // What was taken away has no mass: nothing moves it, and nobody sees it.
  bool is_there(std::size_t i) const { return mass[i] > 0; }

  // Masses are those of the stage, and each step finds its resultants anew.
  void exchange(state::Archive& archive) {
    archive("motion_ux", std::span(ux));
    archive("motion_uy", std::span(uy));
    archive("motion_settled_x", std::span(settled_x));
    archive("motion_settled_y", std::span(settled_y));
    archive("motion_vx", std::span(vx));
    archive("motion_vy", std::span(vy));
    archive("motion_spin", std::span(spin));
    archive.all_or_none("ties", {&tie_x, &tie_y}, size());
  }
};

// The discs of a model at rest.
Particles at_rest(const Model& model);

// Gives the particles the masses of a model, none to those that were taken away.
void set_masses(const Model& model, Particles& particles);

// Masses and moments of inertia of discs without their weights [kg], [kg m^2].
struct Masses {
  std::vector<double> mass, inertia;
};

// Gives the particles that are there other masses to be moved than their own.
void set_moved_masses(const Masses& masses, Particles& particles);

// All velocities and spins become 0.
void stop(Particles& particles);

// Of all particles alike [m/s^2].
struct Acceleration {
  double x = 0, y = 0;
};

// Where forces and moments are summed, one value a particle [N], [N m].
struct Resultants {
  double *fx, *fy, *moment;
};
inline Resultants resultants_of(Particles& p) {
  return {p.fx.data(), p.fy.data(), p.moment.data()};
}

}  // namespace adit::dem
