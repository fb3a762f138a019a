// The particles and bonds that a run computes with: structure of arrays, no gaps.
//
// Places at rest stay, displacements move: a bond's strain then keeps all its digits wherever the model lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/packing/hexagonal.hpp"

namespace adit::dem {

struct Particles {
  std::vector<std::uint32_t> id;                      // place in the packing
  std::vector<double> x, y;                           // centre at rest [m]
  std::vector<double> ux, uy;                         // displacement [m]
  std::vector<double> settled_x, settled_y;           // of it by statics, before time began [m]
  std::vector<double> vx, vy, spin;                   // velocity [m/s], [rad/s]
  std::vector<double> fx, fy, moment;                 // resultants of this step [N], [N m]
  std::vector<double> weight;                         // energy weight, in mass and inertia already
  std::vector<double> mass, inertia;                  // weighted [kg], [kg m^2]
  std::vector<double> inverse_mass, inverse_inertia;  // [1/kg], [1/(kg m^2)]
  std::size_t size() const { return id.size(); }
};

// Where forces and moments are summed, one value a particle [N], [N m].
struct Resultants {
  double *fx, *fy, *moment;
};
inline Resultants resultants_of(Particles& p) {
  return {p.fx.data(), p.fy.data(), p.moment.data()};
}

enum class BondState : std::uint8_t { kIntact = 0, kTensileCrack = 1, kShearCrack = 2 };

// A run: bonds begin … begin + count that are parallel at rest and whose first and second particles each
// follow one another in memory, so that the contact loop loads vectors instead of gathering numbers.
struct Run {
  std::uint32_t begin, count, first, second;
  double rest_x, rest_y;  // from first to second at rest [m]
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

  // All bonds of the run are intact and of weight 1.
  bool plain(const Run& run) const;
  void set_weight(std::uint32_t bond, double value);
  // Leaves a contact without shear. Threads may do so to different bonds.
  void break_bond(std::uint32_t bond, BondState to);
  // As many bonds as there are first ones, intact and of weight 1.
  void finish();

 private:
  static constexpr std::uint32_t kGroup = 64;
  void mark(std::uint32_t bond);
  mutable std::vector<char> marked_;  // of each group of bonds that follow one another: not all are plain
};

struct Assembly {
  Particles particles;
  Bonds bonds;
};

// Energy weights at the particles' centres and the bonds' midpoints, both in the packing's order.
struct SampledWeights {
  std::span<const double> centres, midpoints;
  double floor;  // smallest weight of what exists
};

// What exists under the weights, at rest. A particle whose centre has weight 0 vanishes with its bonds; every
// other bond keeps its midpoint's weight, at least the floor. A particle's weight is the mean of its bonds'
// (of its centre, where none is left), which bounds the critical step: see critical_step.hpp.
Assembly assemble(const Packing& packing, double cell_mass, const SampledWeights& weights);

// The same with all weights 1.
Assembly assemble(const Packing& packing, double cell_mass);

}  // namespace adit::dem
