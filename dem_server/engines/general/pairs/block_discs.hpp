// The discs that the pairs of a block reach, in the cache of the thread that computes it: those of the block,
// then those of other blocks (Pairs::reached). What a pair wants of a disc lies together.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/particles/particles.hpp"

namespace adit::dem {

// Displacement, velocity, place at rest and twice the spin, of which a pair takes the difference and the sum.
struct alignas(64) DiscMotion {
  double ux, uy, vx, vy, x, y, spin, spin_again;
};

// Sums of what pairs do: of those whose first disc it is, and of those whose second it is, which act against
// it. Of the moments, the first counts for the first discs, the second for the second ones.
struct alignas(64) DiscSums {
  struct Sum {
    double x = 0, y = 0, moment_1 = 0, moment_2 = 0;
  } first, second;
};

static_assert(sizeof(DiscMotion) == kDiscValues * sizeof(double) && sizeof(DiscSums) == sizeof(DiscMotion));

class BlockDiscs {
 public:
  // Sets the sums of the block's own discs to 0.
  void clear();
  // The same, and looks them up.
  void take(std::uint32_t block, const Particles& particles);
  // Makes room for the sums of `count` discs of other blocks, and sets them to 0.
  void make_room(std::size_t count);
  // The same for those of other blocks that some of its pairs reach; and puts their sums where they wait.
  void take_reached(std::uint32_t block, const Pairs& pairs, const Particles& particles);
  void give_reached(std::uint32_t block, Pairs& pairs) const;

  // The resultants of the own discs become the sums. Discs whose `swept` is 1, not 0, are kicked by `kick`
  // [s]. Returns the power of their resultants before and now, at the velocities before [W].
  double give(std::uint32_t block, double kick, const std::vector<std::uint8_t>& swept,
              Particles& particles) const;
  // Adds the sums to the resultants of the own discs.
  void add(std::uint32_t block, Particles& particles) const;

  // As values, one disc after another.
  const double* motions() const { return &motions_.front().ux; }
  double* sums() { return &sums_.front().first.x; }

 private:
  std::vector<DiscMotion> motions_ = std::vector<DiscMotion>(kBlock);
  std::vector<DiscSums> sums_ = std::vector<DiscSums>(kBlock);
};

}  // namespace adit::dem
