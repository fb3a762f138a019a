// The rigid-body chain: a tunnel in the plane as rigid bodies, with hinges between them and ground springs
// under each (the paper's section 3.1).
//
// The plane is that of the plan or of the longitudinal section; x and y are any two axes in it, and angles
// are counter-clockwise from x. Displacements and rotations are small, so forces act on the geometry at rest.
// Bodies may differ from each other in section, ground and direction.
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
// act between its centre and the ground there, which has a motion of its own.
struct Body {
  double length = 0;            // distance of its ports [m]
  double angle = 0;             // direction of its axis, from port to port [rad]
  double mass = 0;              // [kg]
  double inertia = 0;           // about the centre [kg m^2]
  Directions ground_stiffness;  // for the whole body, not per metre; 0 if there is no spring
  Directions ground_dashpot;
};

// A spring and a dashpot in parallel. Tension is positive, and so is a motion of the following body to the
// left or counter-clockwise.
struct HingeDirection {
  double stiffness = 0;  // [N/m] or [N m/rad]; not used if there is a curve
  double dashpot = 0;    // [N s/m] or [N m s/rad]
  Curve curve;           // force over deformation, instead of the stiffness: see curve.hpp
};

// An elastic hinge with damping. The direction of its axes is the mean of those of the two bodies.
struct Hinge {
  HingeDirection axial, shear, rotation;
};

// n bodies and the n - 1 hinges between them. A hinge at an end joins the end body to an abutment, which
// moves with the ground of that body and does not rotate; an end without a hinge is free.
struct Chain {
  std::vector<Body> bodies;
  std::vector<Hinge> hinges;
  std::optional<Hinge> start, finish;
};

// Throws protocol::UserError at `chain.bodies[3].mass` and the like if the chain cannot be computed.
void check(const Chain& chain);

}  // namespace adit::simplified::chain
