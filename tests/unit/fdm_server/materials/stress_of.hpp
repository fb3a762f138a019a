// The inverse of fdm_server's strain_of.
#pragma once

#include "fdm_server/materials/solid.hpp"

namespace adit::fdm::test {

inline SolidStress stress_of(const Elasticity& e, const Strain& strain) {
  const double mean = e.lame() * (strain.xx + strain.yy + strain.zz);
  return {mean + 2 * e.shear * strain.xx, mean + 2 * e.shear * strain.yy, mean + 2 * e.shear * strain.zz,
          e.shear * strain.xy};
}

}  // namespace adit::fdm::test
