// The lattice that a run computes with: particles, and bonds as structure of arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/laws/bond_state.hpp"
#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/bonded_neighbours.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

// A run: bonds begin … begin + count that are parallel at rest, have the same factors, and whose first and
// second particles each follow one another in memory, so that the contact loop loads vectors instead of
// gathering numbers.
struct Run {
  std::uint32_t begin, count, first, second;
  double rest_x, rest_y;  // from first to second at rest [m]
  BondFactors factors{};  // of the lattice's law
};
inline constexpr std::uint32_t kLongestRun = 128;

// Runs whose bonds all touch a chosen particle, and runs of which none does.
struct SplitRuns {
  std::vector<Run> touching, others;
};
SplitRuns split(std::span<const Run> runs, const std::vector<bool>& chosen);

struct Bonds {
  std::vector<std::uint32_t> first, second;  // particles
  std::vector<double> weight;                // energy weight
  std::vector<double> intact;                // 1 while bonded, then 0: factor of tension and shear
  std::vector<double> normal_force;          // unweighted, tension positive, as found last [N]
  std::vector<double> shear_force;           // unweighted, on the first particle along its left normal [N]
  std::vector<double> initial_normal_force;  // unweighted, at rest [N]; empty: none
  std::vector<BondState> state;
  std::vector<Run> runs;
  double rest_length = 0;  // 2 R [m]
  std::size_t size() const { return first.size(); }

  // All bonds of the run, and of no other, are intact and of weight 1.
  bool plain(const Run& run) const;
  void set_weight(std::uint32_t bond, double value);
  // Leaves a contact without shear. Threads may do so to different bonds.
  void break_bond(std::uint32_t bond, BondState to);
  // As many bonds as there are first ones, intact and of weight 1.
  void finish();

  // Normal forces follow from the displacements.
  void exchange(state::Archive& archive);

 private:
  void mark(std::uint32_t bond);
  mutable std::vector<std::uint64_t> marked_;  // a bit for each bond: it is not plain
};

inline BondEnds ends_of(const Bonds& bonds) {
  return {bonds.first, bonds.second, bonds.rest_length};
}

struct Assembly {
  Particles particles;
  Bonds bonds;
  Acceleration gravity{};
};

// The assembly of a model at rest whose discs and bonds are a lattice (model/lattice.hpp), its bonds in their
// order.
Assembly assemble(const Model& model);

}  // namespace adit::dem
