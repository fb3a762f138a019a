// What a rigid-body chain is made of: a tunnel in the plane as rigid bodies, hinges between them and ground
// under each (the paper's section 3.1).
//
// Plan or longitudinal section alike: x and y are any two axes of the plane, angles run counter-clockwise
// from x. Displacements and rotations are small, so the geometry at rest stays. Every body may differ from
// the next: sections, strata and the alignment vary as they like.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "simplified/chain/model/curve.hpp"

namespace adit::simplified::chain {

// One value for each local direction: along the axis, across it (to the left), about the centre.
struct Directions {
  double axial = 0;     // [N/m], dashpots [N s/m]
  double lateral = 0;   // [N/m], dashpots [N s/m]
  double rotation = 0;  // [N m/rad], dashpots [N m s/rad]
};

// A rigid prism with its ports in the middle of its two ends. The ground spring and dashpot (the soil joint)
// act between its centre and the ground there, which moves on its own.
struct Body {
  double length = 0;            // between its ports [m]
  double angle = 0;             // of its axis, from port to port [rad]
  double mass = 0;              // [kg]
  double inertia = 0;           // about the centre [kg m^2]
  Directions ground_stiffness;  // whole body, not per metre; 0 where there is none
  Directions ground_dashpot;
};

// Spring and dashpot in parallel. Tension, and motion of the following body to the left or
// counter-clockwise, are positive.
struct HingeDirection {
  double stiffness = 0;  // [N/m] or [N m/rad]; not used where there is a curve
  double dashpot = 0;    // [N s/m] or [N m s/rad]
  Curve curve;           // force over deformation, instead of the stiffness: see curve.hpp
};

// An elastic-damping hinge. Its axes are those of the mean angle of the two bodies.
struct Hinge {
  HingeDirection axial, shear, rotation;
};

// n bodies and the n - 1 hinges between them. An end with a hinge is joined by it to an abutment that moves
// with the ground of the end body and never turns; an end without is free.
struct Chain {
  std::vector<Body> bodies;
  std::vector<Hinge> hinges;
  std::optional<Hinge> start, finish;
};

// Throws protocol::UserError at `chain.bodies[3].mass` and the like where the chain cannot be computed.
void check(const Chain& chain);

}  // namespace adit::simplified::chain
