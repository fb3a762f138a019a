#include "dem_server/engines/general/pairs/block_discs.hpp"

#include <algorithm>

#include "dem_server/engines/general/pairs/lanes.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

DiscMotion motion_of(const Particles& p, std::size_t i) {
  return {p.ux[i], p.uy[i], p.vx[i], p.vy[i], p.x[i], p.y[i], p.spin[i], p.spin[i]};
}

ADIT_VECTOR_CLONES void take_range(const Particles& p, std::size_t begin, std::size_t count, DiscMotion* to) {
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const std::size_t i = begin + k;
    Four moved[4] = {four(&p.ux[i]), four(&p.uy[i]), four(&p.vx[i]), four(&p.vy[i])};
    Four placed[4] = {four(&p.x[i]), four(&p.y[i]), four(&p.spin[i]), four(&p.spin[i])};
    turn(moved);
    turn(placed);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      store(moved[lane], &to[k + lane].ux);
      store(placed[lane], &to[k + lane].x);
    }
  }
  for (; k < count; ++k) to[k] = motion_of(p, begin + k);
}

// The sums of four discs.
struct FourSums {
  Four x, y, moment;
};
[[gnu::always_inline]] inline FourSums of(const DiscSums* sums) {
  using Bits [[gnu::vector_size(32)]] = std::int64_t;
  constexpr Bits kOfFirst{-1, -1, -1, 0}, kOfSecond{-1, -1, 0, -1};
  Four rows[4];
  for (std::size_t lane = 0; lane < 4; ++lane)
    rows[lane] = (Four)((Bits)four(&sums[lane].first.x) & kOfFirst) -
                 (Four)((Bits)four(&sums[lane].second.x) & kOfSecond);
  turn(rows);
  return {rows[0], rows[1], rows[2] - rows[3]};
}

double give_one(const DiscSums& sums, std::size_t i, double kick, bool swept, Particles& p) {
  const double x = sums.first.x - sums.second.x, y = sums.first.y - sums.second.y,
               moment = sums.first.moment_1 + sums.second.moment_2;
  const double power = p.vx[i] * (p.fx[i] + x) + p.vy[i] * (p.fy[i] + y) + p.spin[i] * (p.moment[i] + moment);
  p.fx[i] = x;
  p.fy[i] = y;
  p.moment[i] = moment;
  // Other threads may be reading the velocities of discs that are kept.
  if (!swept) return 0;
  p.vx[i] += kick * x * p.inverse_mass[i];
  p.vy[i] += kick * y * p.inverse_mass[i];
  p.spin[i] += kick * moment * p.inverse_inertia[i];
  return power;
}

// Four discs side by side where all or none are swept: the same ones for any number of threads.
ADIT_VECTOR_CLONES double give_range(const DiscSums* sums, std::size_t begin, std::size_t count, double kick,
                                     const std::uint8_t* swept, Particles& p) {
  Four power{};
  double of_others = 0;
  for (std::size_t k = 0; k < count; k += 4) {
    const std::size_t i = begin + k;
    const int swept_ones = k + 4 > count ? 1 : swept[i] + swept[i + 1] + swept[i + 2] + swept[i + 3];
    if (swept_ones % 4 != 0) {
      for (std::size_t one = k; one < std::min(k + 4, count); ++one)
        of_others += give_one(sums[one], begin + one, kick, swept[begin + one] != 0, p);
      continue;
    }
    const FourSums sum = of(sums + k);
    if (swept_ones == 0) {
      store(sum.x, &p.fx[i]);
      store(sum.y, &p.fy[i]);
      store(sum.moment, &p.moment[i]);
      continue;
    }
    const Four vx = four(&p.vx[i]), vy = four(&p.vy[i]), spin = four(&p.spin[i]);
    power += vx * (four(&p.fx[i]) + sum.x) + vy * (four(&p.fy[i]) + sum.y) +
             spin * (four(&p.moment[i]) + sum.moment);
    store(sum.x, &p.fx[i]);
    store(sum.y, &p.fy[i]);
    store(sum.moment, &p.moment[i]);
    const Four by_mass = four(&p.inverse_mass[i]), by_inertia = four(&p.inverse_inertia[i]);
    store(vx + kick * sum.x * by_mass, &p.vx[i]);
    store(vy + kick * sum.y * by_mass, &p.vy[i]);
    store(spin + kick * sum.moment * by_inertia, &p.spin[i]);
  }
  return power[0] + power[1] + power[2] + power[3] + of_others;
}

std::uint32_t own_count(std::uint32_t block, std::size_t discs) {
  return static_cast<std::uint32_t>(std::min<std::size_t>(kBlock, discs - std::size_t{block} * kBlock));
}

}  // namespace

void BlockDiscs::clear() {
  std::fill_n(sums_.begin(), kBlock, DiscSums{});
}

void BlockDiscs::make_room(std::size_t count) {
  if (sums_.size() < kBlock + count) sums_.resize(kBlock + count);
  std::fill_n(sums_.begin() + kBlock, count, DiscSums{});
}

void BlockDiscs::take(std::uint32_t block, const Particles& p) {
  clear();
  take_range(p, block * kBlock, own_count(block, p.size()), motions_.data());
}

void BlockDiscs::take_reached(std::uint32_t block, const Pairs& pairs, const Particles& p) {
  const std::uint32_t begin = pairs.reach_starts[block], end = pairs.reach_starts[block + 1];
  const std::size_t size = kBlock + (end - begin);
  if (motions_.size() < size) motions_.resize(size);
  make_room(end - begin);
  for (std::uint32_t k = begin; k < end; ++k) motions_[kBlock + (k - begin)] = motion_of(p, pairs.reached[k]);
}

void BlockDiscs::give_reached(std::uint32_t block, Pairs& pairs) const {
  const std::uint32_t begin = pairs.reach_starts[block], end = pairs.reach_starts[block + 1];
  for (std::uint32_t k = begin; k < end; ++k) {
    const DiscSums::Sum& sum = sums_[kBlock + (k - begin)].second;
    pairs.away_x[k] = sum.x;
    pairs.away_y[k] = sum.y;
    pairs.away_moment[k] = sum.moment_2;
  }
}

double BlockDiscs::give(std::uint32_t block, double kick, const std::vector<std::uint8_t>& swept,
                        Particles& p) const {
  return give_range(sums_.data(), std::size_t{block} * kBlock, own_count(block, p.size()), kick, swept.data(),
                    p);
}

void BlockDiscs::add(std::uint32_t block, Particles& p) const {
  for (std::uint32_t k = 0; k < own_count(block, p.size()); ++k) {
    const std::size_t i = std::size_t{block} * kBlock + k;
    p.fx[i] += sums_[k].first.x - sums_[k].second.x;
    p.fy[i] += sums_[k].first.y - sums_[k].second.y;
    p.moment[i] += sums_[k].first.moment_1 + sums_[k].second.moment_2;
  }
}

}  // namespace adit::dem
