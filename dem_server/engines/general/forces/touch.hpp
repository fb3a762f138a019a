// One contact that is computed by itself, from step to step: the springs, friction and dashpots of
// laws/linear_contact.hpp where two surfaces meet.
#pragma once

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/pair_kinematics.hpp"

namespace adit::dem {

// Where the surfaces of two bodies meet.
struct Encounter {
  double nx, ny;                   // from the first to the second
  double gap;                      // negative: they press on each other [m]
  PlaneVector arm_1, arm_2;        // from the bodies' centres to where they meet [m]
  double stretch_rate, slip_rate;  // of the second against the first, along n and its left normal [m/s]
  double stiffening = 1;           // by which the stiffness of the law's normal spring is multiplied
};

// Of two bodies; 0 of one that nothing moves.
struct InverseMasses {
  double mass_1, inertia_1, mass_2 = 0, inertia_2 = 0;  // [1/kg], [1/(kg m^2)]
};

struct Touch {
  double stiffness = 0;          // of the normal spring while it acts [N/m]
  double shear = 0;              // of the spring [N]
  double normal = 0;             // of spring and dashpot [N]
  ContactForces dashpots{0, 0};  // their share [N]
};

// Taken in a step [J].
struct TouchLoss {
  double friction, dashpots;
};

// Forces on the first body along n and its left normal, of `touch` after the step.
struct TouchStep {
  ContactForces forces{0, 0};
  TouchLoss loss{0, 0};
};
TouchStep advance(const LinearContact& law, const Encounter& now, const InverseMasses& inverse, double dt,
                  Touch& touch);

// Stored in the springs [J].
double strain_energy(const LinearContact& law, const Touch& touch);

}  // namespace adit::dem
