// Forces of bonds and contacts: the kernel of the solver.
//
// A bond joins particles 1 and 2, n is the unit vector from 1 to 2 where they are now, t its left normal, L
// the distance, L0 = 2R. It pulls particle 1 by Fn n + Fs t, and particle 2 by the opposite:
//   Fn = F0 + kn (L - L0), from the displacements alone, F0 being the bond's force before anything acts;
//   Fs += ks dt ((v2 - v1).t - (w1 + w2) L / 2), the relative velocity where the halves of the bond meet.
// The force acts at the middle of the bond, so both particles feel the moment Fs L / 2: the two moments and
// the pair of shear forces balance, momentum and angular momentum are kept to rounding, and the power of the
// forces is exactly that of the relative velocity.
//
// A bond breaks in tension where Fn exceeds its tensile strength, else in shear where |Fs| exceeds its shear
// strength (strengths and stored forces know no energy weight). What is left is a contact without
// friction: Fn = min(F0 + kn (L - L0), 0), Fs = 0, from the breaking step on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/model/calibration.hpp"
#include "dem_server/engines/lattice/assembly.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::dem {

struct BondLaw {
  BondStiffness stiffness;  // [N/m]
  double tensile_strength;  // [N], infinite where unbreakable
  double shear_strength;    // [N]
};

struct ContactResult {
  double max_normal_force = 0;       // largest |Fn| after breaking [N]; not finite where any Fn is not
  std::uint32_t strongest_bond = 0;  // the first that carries it
  // Stored in bonds when they broke in this step, weighted [J]. In the leap-frog scheme's own form,
  // F(n-1) F(n) / 2k instead of F(n)^2 / 2k, so that the energy ledger closes to rounding at a break.
  double released = 0;

  // Of bonds that were taken later.
  void add(const ContactResult& later);
};

// Sets the resultants of some particles to 0.
void clear(std::span<const protocol::IndexRange> some, const Resultants& resultants);

// Adds the forces of the runs' contacts to the resultants, from displacements at n and velocities at n - 1/2.
// `result` grows to that of all runs of the step so far; bonds that broke are appended to `broken`.
void add_contact_forces(const BondLaw& law, double dt, std::span<const Run> runs, const Particles& particles,
                        Bonds& bonds, const Resultants& resultants, ContactResult& result,
                        std::vector<std::uint32_t>& broken);

// The present normal forces of all bonds, unweighted [N], which add_contact_forces does not keep: they follow
// from the displacements.
void find_normal_forces(const BondLaw& law, const Particles& particles, const Bonds& bonds,
                        std::span<double> normal);

// Stored in the runs' bonds, weighted [J]: normal forces follow from the displacements, shear forces are as
// noted.
double strain_energy(const BondLaw& law, std::span<const Run> runs, const Particles& particles,
                     const Bonds& bonds);

// All of these for all particles and all bonds.
ContactResult compute_contact_forces(const BondLaw& law, double dt, Particles& particles, Bonds& bonds,
                                     std::vector<std::uint32_t>& broken);

}  // namespace adit::dem
