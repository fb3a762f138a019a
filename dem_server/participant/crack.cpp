#include "dem_server/participant/crack.hpp"

#include <cmath>
#include <numbers>

namespace adit::dem {

Place middle_of_bond(const Assembly& assembly, std::uint32_t bond) {
  const Particles& p = assembly.particles;
  const std::uint32_t i = assembly.bonds.first[bond], j = assembly.bonds.second[bond];
  return {0.5 * (p.x[i] + p.x[j]), 0.5 * (p.y[i] + p.y[j])};
}

Crack crack_of_bond(const Assembly& assembly, std::uint32_t bond) {
  const Particles& p = assembly.particles;
  const Bonds& b = assembly.bonds;
  const std::uint32_t i = b.first[bond], j = b.second[bond];
  // The second particle is right of or above the first: the bond's angle lies in [0, pi), and the edge's,
  // a quarter turn less, in [-pi/2, pi/2).
  double orientation = std::atan2(p.y[j] - p.y[i], p.x[j] - p.x[i]) - std::numbers::pi / 2;
  if (orientation <= -std::numbers::pi / 2) orientation += std::numbers::pi;
  const auto [x, y] = middle_of_bond(assembly, bond);
  return {b.state[bond], x, y, b.rest_length / std::numbers::sqrt3, orientation, p.id[i], p.id[j]};
}

}  // namespace adit::dem
