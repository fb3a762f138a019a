// The kernels over ranges of hinges and bodies: what the joints do, and what remains unbalanced.
#pragma once

#include <array>
#include <cstddef>

#include "simplified/chain/joints/integrator.hpp"
#include "simplified/chain/model/model.hpp"

namespace adit::simplified::chain {

// Displacements (or velocities) of all places, abutments included.
struct Field {
  const double *x, *y, *rotation;
};
using Tracks = std::array<Track, 3>;  // x, y, rotation
Field predicted_displacement(const Tracks& tracks);
Field predicted_velocity(const Tracks& tracks);
Field displacement(const Tracks& tracks);
Field velocity(const Tracks& tracks);

// Forces of the hinges begin … end - 1 on the place before each (those on the place after are opposite), in
// the axes of the plane, for the displacements x and velocities v: turned offset + K delta + C delta'.
void hinge_forces(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
                  Components& forces);

// What the bodies begin … end - 1 lack of balance without their inertia:
// r = load - K x - C v + G_O^T f_after - G_I^T f_before, with `load` that of ground and outer forces.
void unbalanced(const Model& model, const Field& x, const Field& v, const Components& load,
                const Components& hinge_forces, std::size_t begin, std::size_t end, Components& r);

// Deformations of the hinges begin … end - 1 and their forces, those at rest included, in the hinges' own
// axes.
void measure(const Model& model, const Field& x, const Field& v, std::size_t begin, std::size_t end,
             Components& deformation, Components& force);

// The deformation of one hinge in one direction, for the displacements x.
double deformation(const Model& model, const Field& x, std::size_t hinge, std::size_t direction);

}  // namespace adit::simplified::chain
