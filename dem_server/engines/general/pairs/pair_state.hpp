// One pair of discs as it is now: its shape, its forces, what it stores.
#pragma once

#include <cstdint>
#include <span>

#include "dem_server/engines/general/pairs/block_discs.hpp"
#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/parallel_bond.hpp"

namespace adit::dem {

// The springs of a pair's bond; 0 where it never had any.
BondSprings springs_of(const PairLaw& law, const Pairs& pairs, std::uint32_t pair);

// The shape of a pair whose second disc has moved by (ux, uy) more than its first.
PairShape shape_of(const Pairs& pairs, std::uint32_t pair, double ux, double uy);

// Forces now, unweighted and without dashpots.
struct PairState {
  double nx, ny, length;
  double bond_normal, contact_normal;  // tension positive [N]
  double shear, moment;                // [N], [N m]
  bool touches;
};
PairState state_of(std::uint32_t pair, std::span<const PairLaw> laws, const Particles& particles,
                   const Pairs& pairs);

// Stored in contacts, contact bonds and parallel bonds, weighted [J].
struct Stored {
  double contacts = 0, contact_bonds = 0, parallel_bonds = 0;
  double sum() const { return contacts + contact_bonds + parallel_bonds; }
  void add(const Stored& other, double share = 1) {
    contacts += share * other.contacts;
    contact_bonds += share * other.contact_bonds;
    parallel_bonds += share * other.parallel_bonds;
  }
};
// Adds what the pairs of a block store, whose own discs `of_block` has taken.
void add_stored(std::uint32_t block, std::span<const PairLaw> laws, const Particles& particles,
                const Pairs& pairs, BlockDiscs& of_block, Stored& stored);

}  // namespace adit::dem
