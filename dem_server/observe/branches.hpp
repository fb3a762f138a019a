// What holds particles together and carries forces through them, for fragments.hpp and circles.hpp.
#pragma once

#include <vector>

#include "dem_server/lining/sections.hpp"
#include "dem_server/observe/circles.hpp"
#include "dem_server/observe/observable.hpp"
#include "dem_server/packing/discs.hpp"

namespace adit::dem {

// Particles that a bond joins or joined, in the order of for_each_bond.
std::vector<Pair> all_bonds(const Observable& observed);
// Particles that a whole bond joins.
std::vector<Pair> whole_bonds(const Observable& observed);
// Those of them that hold their particles in place: one that hangs on a single bond rolls, unless the bond
// resists turning.
std::vector<Pair> firm_bonds(const Observable& observed);
// Whole bonds, and particles that touch otherwise.
std::vector<Pair> touching_particles(const Observable& observed);

// Forces of bonds, contacts, joints, springs and walls as they are, without energy weights and dashpots; a
// wall's branch ends where the particle touches it.
std::vector<Branch> branches_of(const Observable& observed);

// Forces between particles for sections.hpp: those of these bonds, and of all contacts, smooth joints and
// springs.
std::vector<PairForce> pair_forces_of(const Observable& observed, std::span<const std::uint32_t> bonds);

// Mean stress of each particle over its cell of area A, tension positive [Pa]: that of a body at rest under
// the forces f on its surface at the arms c from its centre is
//   sigma = 1/A sum c x f,     by the divergence theorem,
// of which the symmetric part is taken (bonds also bend). It is exact for an even state of a lattice; loads
// and ties to another model add nothing, so that it is too small where they act. 0 of particles that were
// taken away.
std::vector<Tensor> particle_stress(const Observable& observed);

// Of all sections, as they are now.
std::vector<SectionForces> section_forces(const Observable& observed, const Sections& sections);

}  // namespace adit::dem
