#include "dem_server/condensation/tangent.hpp"

#include <algorithm>
#include <cmath>

#include "protocol/motion/random.hpp"

namespace adit::dem {
namespace {

// A motion over the radius: so small that what is of second order in it does not show, and so large that the
// rounding of forces a thousandth of the stiffness times the radius does not either.
constexpr double kSmall = 0x1p-30;

void sort_out(std::vector<std::uint32_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

// Those of the neighbours, with itself.
Neighbourhood widened(const Neighbourhood& near) {
  Neighbourhood wide(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (const std::uint32_t j : near[i]) wide[i].insert(wide[i].end(), near[j].begin(), near[j].end());
    sort_out(wide[i]);
  }
  return wide;
}

// Of each particle, none that has a neighbour's in `apart`.
std::vector<std::uint32_t> colours_of(const Neighbourhood& apart) {
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> colour(apart.size(), kNone);
  std::vector<bool> taken;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    taken.assign(apart[i].size() + 1, false);
    for (const std::uint32_t j : apart[i])
      if (colour[j] < taken.size()) taken[colour[j]] = true;
    colour[i] = static_cast<std::uint32_t>(std::ranges::find(taken, false) - taken.begin());
  }
  return colour;
}

double step_of(double radius, std::size_t freedom) {
  return kSmall * (freedom == 2 ? 1 : radius);
}

double one_sidedness(std::span<const double> radius, const std::vector<double>& at_rest,
                     const ForcesAfter& forces_after) {
  motion::Random random(1);
  std::vector<double> motion(at_rest.size());
  for (std::size_t k = 0; k < motion.size(); ++k)
    motion[k] = (2 * random.uniform() - 1) * step_of(radius[k / kFreedoms], k % kFreedoms);
  const std::vector<double> one = forces_after(motion);
  for (double& value : motion) value = -value;
  const std::vector<double> other = forces_after(motion);
  double even = 0, odd = 0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    even += std::pow(one[k] + other[k] - 2 * at_rest[k], 2);
    odd += std::pow(one[k] - other[k], 2);
  }
  return odd > 0 ? std::sqrt(even / odd) : 0;
}

}  // namespace

Neighbourhood neighbourhood_of(std::size_t particles, std::span<const std::uint32_t> first,
                               std::span<const std::uint32_t> second) {
  Neighbourhood near(particles);
  for (std::uint32_t i = 0; i < particles; ++i) near[i].push_back(i);
  for (std::size_t k = 0; k < first.size(); ++k) {
    near[first[k]].push_back(second[k]);
    near[second[k]].push_back(first[k]);
  }
  return widened(near);
}

Tangent tangent_of(std::span<const double> radius, const Neighbourhood& reach,
                   const ForcesAfter& forces_after) {
  const std::size_t size = kFreedoms * reach.size();
  std::vector<double> motion(size, 0.0);
  Tangent tangent{{}, forces_after(motion), 0};
  const std::vector<std::uint32_t> colours = colours_of(widened(reach));
  const std::uint32_t count = reach.empty() ? 0 : std::ranges::max(colours) + 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t colour = 0; colour < count; ++colour)
    for (std::size_t freedom = 0; freedom < kFreedoms; ++freedom) {
      std::ranges::fill(motion, 0.0);
      for (std::size_t j = 0; j < reach.size(); ++j)
        if (colours[j] == colour) motion[kFreedoms * j + freedom] = step_of(radius[j], freedom);
      const std::vector<double> forces = forces_after(motion);
      for (std::size_t j = 0; j < reach.size(); ++j) {
        if (colours[j] != colour) continue;
        const std::size_t column = kFreedoms * j + freedom;
        for (const std::uint32_t i : reach[j])
          for (std::size_t k = kFreedoms * i; k < kFreedoms * (i + 1); ++k)
            if (const double change = tangent.forces[k] - forces[k]; change != 0)
              entries.emplace_back(static_cast<int>(k), static_cast<int>(column), change / motion[column]);
      }
    }
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::SparseMatrix<double> measured(n, n);
  measured.setFromTriplets(entries.begin(), entries.end());
  tangent.stiffness = 0.5 * (measured + Eigen::SparseMatrix<double>(measured.transpose()));
  tangent.one_sidedness = one_sidedness(radius, tangent.forces, forces_after);
  return tangent;
}

}  // namespace adit::dem
