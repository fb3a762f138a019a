// The discs that the pairs of a block reach, in the cache of the thread that computes it: those of the block,
// then those of other blocks (Pairs::reached). What a pair wants of a disc lies together.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/general/pairs/lanes.hpp"
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

// Adds what pairs or facets do to the sums of their discs, in their order: columns of the forces and moments
// on the first disc and the moments on the second. `first` and `second` are places in the list of sums, in
// units of `kUnit` values.
template <std::uint32_t kUnit>
[[gnu::always_inline]] inline void add_to_sums(std::uint32_t count, const std::uint32_t* first,
                                               const std::uint32_t* second, const double* x, const double* y,
                                               const double* moment_1, const double* moment_2, double* sums) {
  for (std::uint32_t k = 0; k < count; k += 4) {
    Four rows[4] = {four(x + k), four(y + k), four(moment_1 + k), four(moment_2 + k)};
    turn(rows);
    const auto add = [&](std::uint32_t lane) __attribute__((always_inline)) {
      double *of_first = sums + std::size_t{kUnit} * first[k + lane],
             *of_second = sums + std::size_t{kUnit} * second[k + lane] + kDiscValues / 2;
      store(four(of_first) + rows[lane], of_first);
      store(four(of_second) + rows[lane], of_second);
    };
    if (k + 4 <= count)
      for (std::uint32_t lane = 0; lane < 4; ++lane) add(lane);
    else
      for (std::uint32_t lane = 0; lane < count - k; ++lane) add(lane);
  }
}

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
