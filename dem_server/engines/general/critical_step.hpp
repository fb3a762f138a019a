// Largest time step at which the discs of a model stay stable, by a bound that holds whatever touches.
//
// The highest frequency of an assembly is at most that of its worst element (Irons), however the discs'
// masses m and moments of inertia J are shared between the elements. Every bond, joint, spring and contact
// gets of its discs the share of its stiffness, k = max(kn, ks) for the mass and r = ks arm^2 + km for the
// inertia. Alone, it then has
//   stretching:  omega^2 = kn (A_1 + A_2),   A = (sum of the disc's k) / (k m),
//   slipping and turning: the larger eigenvalue of their two springs, coupled where the discs differ.
// A disc is surrounded by at most pi / asin(q / (R + q)) others, q being the smallest radius; those that it
// is not joined to are counted as contacts of the stiffest kind, and so are two walls.
#pragma once

#include "dem_server/engines/answers.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

// The element with the smallest critical step, of a model with at least one disc; infinite where nothing has
// a stiffness. A contact stands where its disc does.
CriticalElement critical_element(const Model& model);
inline double critical_step(const Model& model) {
  return critical_element(model).step;
}

}  // namespace adit::dem
