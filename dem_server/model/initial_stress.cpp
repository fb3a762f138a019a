#include "dem_server/model/initial_stress.hpp"

#include <numbers>

namespace adit::dem {

BondForces initial_forces(const InitialStress& stress, const BondStiffness& stiffness, const RestBond& bond) {
  const double kn = stiffness.normal, ks = stiffness.shear, length = bond.length;
  // lambda + mu and mu of the lattice, by which mean stress and deviators strain it
  const double bulk = std::numbers::sqrt3 / 2 * kn, shear = std::numbers::sqrt3 / 4 * (kn + ks);
  const double nx = bond.x / length, ny = bond.y / length;
  const double cos_2 = nx * nx - ny * ny, sin_2 = 2 * nx * ny;
  const double xx = stress.xx + stress.xx_per_metre * bond.height;
  const double yy = stress.yy + stress.yy_per_metre * bond.height;
  const double mean = (xx + yy) / 2 / bulk, deviator = (xx - yy) / 2 / shear, xy = stress.xy / shear;
  return {kn * length * (mean + deviator * cos_2 + xy * sin_2) / 2,
          ks * length * (xy * cos_2 - deviator * sin_2) / 2};
}

}  // namespace adit::dem
