#include "dem_server/engines/lattice/initial_stress.hpp"

#include <numbers>

namespace adit::dem {

void set_initial_stress(const scene::Stress& stress, const BondStiffness& stiffness, Assembly& assembly) {
  const Particles& p = assembly.particles;
  Bonds& b = assembly.bonds;
  const double kn = stiffness.normal, ks = stiffness.shear, length = b.rest_length;
  // lambda + mu and mu of the lattice, by which mean stress and deviators strain it
  const double bulk = std::numbers::sqrt3 / 2 * kn, shear = std::numbers::sqrt3 / 4 * (kn + ks);
  b.initial_normal_force.resize(b.size());
  for (const Run& run : b.runs) {
    const double nx = run.rest_x / length, ny = run.rest_y / length;
    const double cos_2 = nx * nx - ny * ny, sin_2 = 2 * nx * ny;
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const std::uint32_t bond = run.begin + k;
      const double y = (p.y[run.first + k] + p.y[run.second + k]) / 2;
      const double xx = stress.xx() + stress.xx_per_metre() * y;
      const double yy = stress.yy() + stress.yy_per_metre() * y;
      const double mean = (xx + yy) / 2 / bulk, deviator = (xx - yy) / 2 / shear, xy = stress.xy() / shear;
      b.initial_normal_force[bond] = kn * length * (mean + deviator * cos_2 + xy * sin_2) / 2;
      b.shear_force[bond] = ks * length * (xy * cos_2 - deviator * sin_2) / 2;
    }
  }
  b.normal_force = b.initial_normal_force;
}

}  // namespace adit::dem
