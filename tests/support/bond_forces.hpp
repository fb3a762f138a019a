// The forces of a lattice in passes over all bonds, which the lattice engine's sweep makes block by block.
#pragma once

#include <vector>

#include "dem_server/engines/lattice/bond_forces.hpp"
#include "dem_server/particles/integrate.hpp"

namespace adit::dem::test {

inline BondResult compute_bond_forces(const ContactBond& law, double dt, Particles& particles, Bonds& bonds,
                                      std::vector<std::uint32_t>& broken) {
  const protocol::IndexRange all{0, static_cast<std::uint32_t>(particles.size())};
  clear({&all, 1}, resultants_of(particles));
  BondResult result;
  add_bond_forces(law, dt, bonds.runs, particles, bonds, resultants_of(particles), result, broken);
  find_normal_forces(law, particles, bonds, bonds.normal_force);
  return result;
}

}  // namespace adit::dem::test
