// A step of a rank's part.
#include <algorithm>
#include <bit>
#include <cmath>

#include "adapters/lammps/particles/part.hpp"
#include "dem_server/particles/integrate.hpp"

namespace adit::lammps {
namespace {

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
}

}  // namespace

void Part::move(double dt) {
  const protocol::IndexRange own = own_range();
  moved.add(dt * std::sqrt(dem::move(dt, {&own, 1}, particles)));
}

void Part::pull(double dt) {
  dem::Particles& p = particles;
  for (auto* sum : {&p.fx, &p.fy, &p.moment}) std::ranges::fill(*sum, 0.0);
  broken_.clear();
  strongest_ = {};
  dem::PairResult result;
  const auto blocks = static_cast<std::uint32_t>(dem::blocks_of(own_));
  for (std::uint32_t block = 0; block < blocks; ++block) {
    discs_.take(block, p);
    for (auto* sets : {&bonds_, &contacts_})
      for (Share& from : *sets) {
        dem::add_pair_forces(block, laws.all, dt, false, p, from.set.pairs, discs_, result);
        add(result, from);
      }
    discs_.add(block, p);
  }
  for (std::uint32_t block = 0; block < blocks; ++block)
    for (auto* sets : {&bonds_, &contacts_})
      for (const Share& from : *sets) dem::gather_pair_forces(block, from.set.pairs, p);
}

void Part::add(const dem::PairResult& result, const Share& from) {
  const dem::Pairs& pairs = from.set.pairs;
  friction += from.share * result.friction;
  dashpots += from.share * result.dashpots;
  released += from.share * result.released;
  for (const std::uint32_t k : result.broken) {
    const std::uint32_t i = pairs.first[k], j = pairs.second[k];
    if ((particles.id[i] < particles.id[j] ? i : j) < own_)
      broken_.push_back({from.set.number[k], static_cast<double>(pairs.state[k])});
  }
  if (pairs.bonded() != laws.bonded ||
      bits_of_size(result.max_normal_force) <= bits_of_size(strongest_.force))
    return;
  const std::uint32_t i = pairs.first[result.strongest], j = pairs.second[result.strongest];
  strongest_ = {result.max_normal_force, (particles.x[i] + particles.x[j]) / 2,
                (particles.y[i] + particles.y[j]) / 2};
}

dem::Stored Part::stored() const {
  dem::Stored sum;
  const auto blocks = static_cast<std::uint32_t>(dem::blocks_of(own_));
  for (std::uint32_t block = 0; block < blocks; ++block) {
    discs_.take(block, particles);
    for (const auto* sets : {&bonds_, &contacts_})
      for (const Share& from : *sets) {
        dem::Stored stored;
        dem::add_stored(block, laws.all, particles, from.set.pairs, discs_, stored);
        sum.add(stored, from.share);
      }
  }
  return sum;
}

}  // namespace adit::lammps
