// Kernels over ranges of hinges and bodies: the forces of the hinges, and the unbalanced forces of the
// bodies.
#pragma once

#include <array>
#include <cstddef>

#include "simplified/chain/joints/integrator.hpp"
#include "simplified/chain/model/model.hpp"

namespace adit::simplified::chain {

// Displacements (or velocities) of all bodies and of the two abutments.
struct Field {
  const double *x, *y, *rotation;
};
using Tracks = std::array<Track, 3>;  // x, y, rotation
Field predicted_displacement(const Tracks& tracks);
Field predicted_velocity(const Tracks& tracks);
Field displacement(const Tracks& tracks);
Field velocity(const Tracks& tracks);

// Forces offset + K delta + C delta' of the hinges begin … end - 1 at the displacements x and velocities v,
// in the axes of the plane. They act on the body before each hinge, and the opposite forces on the body after
// it.
void hinge_forces(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
                  Components& forces);

// Unbalanced forces of the bodies begin … end - 1, without inertia:
// r = load - K x - C v + G_O^T f_after - G_I^T f_before, where `load` contains the forces of the ground's
// motion and outer forces.
void unbalanced(const Model& model, const Field& x, const Field& v, const Components& load,
                const Components& hinge_forces, std::size_t begin, std::size_t end, Components& r);

// Deformations of the hinges begin … end - 1 and their forces, including those at rest, in the axes of the
// hinges.
void measure(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
             Components& deformation, Components& force);

// The deformation of one hinge in one direction, at the displacements x.
double deformation(const Model& model, const Field& x, std::size_t hinge, std::size_t direction);

}  // namespace adit::simplified::chain
