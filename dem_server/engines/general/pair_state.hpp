// One pair of discs as it is now: where it stands, what pulls in it, what it stores.
#pragma once

#include <cstdint>
#include <span>

#include "dem_server/engines/general/pairs.hpp"

namespace adit::dem {

// The springs of a pair's cement [N/m], [N/m], [N m]; 0 where it never had any.
struct Cement {
  double kn, ks, km;
};
Cement cement_of(const PairLaw& law, const Pairs& pairs, std::uint32_t pair);

// The shape of a pair whose second disc has moved by (ux, uy) more than its first.
struct PairShape {
  double nx, ny, length, elongation, arm_1, arm_2;
};
PairShape shape_of(const Pairs& pairs, std::uint32_t pair, double ux, double uy);

// Forces now, unweighted and without dashpots.
struct PairState {
  double nx, ny, length;
  double cement_normal, contact_normal;  // tension positive [N]
  double shear, moment;                  // [N], [N m]
  bool touches;
};
PairState state_of(std::uint32_t pair, std::span<const PairLaw> laws, const Particles& particles,
                   const Pairs& pairs);

// Stored in contacts, contact bonds and parallel bonds, weighted [J].
struct Stored {
  double contacts = 0, contact_bonds = 0, parallel_bonds = 0;
  double sum() const { return contacts + contact_bonds + parallel_bonds; }
};
void add_stored(std::span<const PairLaw> laws, const Particles& particles, const Pairs& pairs,
                Stored& stored);

}  // namespace adit::dem
