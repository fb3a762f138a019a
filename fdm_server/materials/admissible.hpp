// Where a predicted stress goes in a material with Mohr-Coulomb's strength, a weak plane or both.
//
// With both: the weaker alone takes the flow if that satisfies the other too, the plane before the ground
// between the planes. Where both flow, they return in turn from the predictor until both are satisfied.
#pragma once

#include "fdm_server/materials/material.hpp"

namespace adit::fdm {

struct Admissible {
  SolidStress stress;
  double plastic_shear_strain;  // that Mohr-Coulomb's flow adds (shear_measure)
  unsigned yields;              // bits of now
};
Admissible admissible(const Material& material, const Elasticity& elasticity, double plastic_shear_strain,
                      const SolidStress& predicted, const PlaneDirection& planes);

}  // namespace adit::fdm
