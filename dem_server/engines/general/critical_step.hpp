// Largest time step at which the discs of a model stay stable, by a bound that holds whatever touches and
// breaks.
//
// Springs. The highest frequency of an assembly is at most that of its worst element (Irons), however the
// discs' masses m and moments of inertia J are shared between the elements. Every bond, joint, spring, bar
// element and contact gets of its discs the share of its stiffness, k = max(kn, ks) for the mass and r = ks
// arm^2 + km for the inertia. Alone, it then has
//   stretching:  omega^2 = kn (A_1 + A_2),   A = (sum of the disc's k) / (k m),
//   slipping and turning: the larger eigenvalue of their two springs, coupled where the discs differ.
//
// Facets oscillate together, and omega^2 of all of them is found by itself (facets/highest_frequency.hpp); it
// is added to that of the other elements, which then have all masses to themselves: the quotient of Rayleigh
// of both is at most the sum of the largest of each. A cell that facets join touches others only where it has
// none: this takes a facet's place.
//
// What touches. A disc that is no such cell is surrounded by at most pi / asin(q / (R + q)) others, q being
// the smallest radius; those that it is not joined to are counted as contacts of the stiffest kind, and so
// are two walls. A bond that can break counts as a contact of the stiffest kind where that is stiffer: its
// place may be taken by any other disc.
//
// Dashpots. They appear where bonds break and discs meet, and look back: their force takes the velocity of n
// − ½. With springs K and dashpots C,
//   M (v+ − v-) / dt = −C v- − K u,   that is   (M − dt C/2) (v+ − v-) / dt = −C (v+ + v-) / 2 − K u,
// which is leap-frog with damping at n and the masses M − dt C/2: its energy only falls as long as
// M − dt C/2 − dt^2 K/4 is positive. So dashpots count as springs of 2 c / dt, the sums over the elements
// hold as before, and the step is stable if no element's omega^2 dt^2 exceeds 4 with k + 2 c / dt in place of
// k. A contact's own law (laws/linear_contact.hpp) divides spring and dashpot by 1 + c dt / 2 m*, m* the mass
// of the pair, and has c = 2 beta sqrt(m* k). With x = dt sqrt(k / m*) a contact counts as
//   k (1 + 4 beta / x) / (1 + beta x)       or as k, where its spring acts alone.
// dt^2 times this grows with dt, so that the largest stable step is found by bisection. Where a pair is not
// known, m* is bounded by the disc and the heaviest of the model. Equal discs between walls get 0.76, 0.59
// and 0.32 of the step of their springs for beta = 0.1, 0.2 and 0.5.
//
// A foundation of the stiffness k per area adds k / rho, rho being a cell's density, to every omega^2: the
// quotient of Rayleigh of both together is at most the sum of the largest of each.
//
// Statics give each disc masses of its own: in proportion to the sums of k and of r over what it is joined to
// and may touch, M = mu sum of k, J = mu c sum of r. Then all A are 1 / (mu k), and all elements stretch with
// omega^2 = 2 kn / (mu k). A wide c keeps rotation from governing. mu follows from the step that is to be the
// critical one. It is one for all stages: the coupler knows the masses of discs that it ties, and whose
// neighbours no stage changes.
//
// Local damping a (Cundall 1987) makes up to 1 + a of each force: the step is divided by sqrt(1 + a).
#pragma once

#include "dem_server/engines/answers.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

// The element with the smallest critical step, of a model with at least one disc; infinite where nothing has
// a stiffness. A contact stands where its disc does.
CriticalElement critical_element(const Model& model);
inline double critical_step(const Model& model) {
  return critical_element(model).step;
}

// The masses of statics, where no dashpots act, from mu = CriticalElement::mass_per_stiffness.
Masses scaled_masses(const Model& model, double mass_per_stiffness);

}  // namespace adit::dem
