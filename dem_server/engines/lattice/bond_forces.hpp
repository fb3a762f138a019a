// Forces of contact bonds of particles of one size (laws/contact_bond.hpp): the kernel of the lattice engine.
//
// L0 = 2R, and both arms are L / 2. All bonds have one law, apart from the factors of their runs. Strengths
// and stored forces know no energy weight. What is left of a broken bond is a contact without friction: N =
// min(N0 + kn (L - L0), 0), S = 0, from the breaking step on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/laws/contact_bond.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {

struct BondResult {
  double max_normal_force = 0;       // largest |Fn| after breaking [N]; not finite where any Fn is not
  std::uint32_t strongest_bond = 0;  // the first that carries it
  // Stored in bonds when they broke in this step, weighted [J]. In the leap-frog scheme's own form,
  // F(n-1) F(n) / 2k instead of F(n)^2 / 2k, so that the energy ledger closes to rounding at a break.
  double released = 0;

  // Adds the result of bonds that were taken later.
  void add(const BondResult& later);
};

// Sets the resultants of some particles to 0.
void clear(std::span<const protocol::IndexRange> some, const Resultants& resultants);

// Adds the forces of the runs' bonds to the resultants, from displacements at n and velocities at n - 1/2.
// `result` grows to that of all runs of the step so far; bonds that broke are appended to `broken`.
void add_bond_forces(const ContactBond& law, double dt, std::span<const Run> runs, const Particles& particles,
                     Bonds& bonds, const Resultants& resultants, BondResult& result,
                     std::vector<std::uint32_t>& broken);

// The present normal forces of all bonds, unweighted [N], which add_bond_forces does not keep: they follow
// from the displacements.
void find_normal_forces(const ContactBond& law, const Particles& particles, const Bonds& bonds,
                        std::span<double> normal);

// Stored in the runs' bonds, weighted [J]: normal forces follow from the displacements, shear forces are as
// noted.
double strain_energy(const ContactBond& law, std::span<const Run> runs, const Particles& particles,
                     const Bonds& bonds);

// Sum over all bonds of |force|, weighted [N].
double internal_force(const ContactBond& law, const Particles& particles, const Bonds& bonds);

}  // namespace adit::dem
