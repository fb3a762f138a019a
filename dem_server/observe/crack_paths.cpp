#include "dem_server/observe/crack_paths.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

#include "dem_server/observe/fragments.hpp"

namespace adit::dem {
namespace {

constexpr double kMeet = 1e-5;  // of the mean length

struct End {
  double x, y;
  std::uint32_t crack;
  auto operator<=>(const End&) const = default;
};

// Cracks within groups of which an end of one lies at an end of the other.
std::vector<Pair> meeting(std::span<const ObservedCrack> cracks) {
  std::vector<End> ends;
  double reach = 0;
  for (std::uint32_t k = 0; k < cracks.size(); ++k) {
    reach += kMeet * cracks[k].length() / static_cast<double>(cracks.size());
    if (cracks[k].debonded) continue;
    ends.push_back({cracks[k].x_1, cracks[k].y_1, k});
    ends.push_back({cracks[k].x_2, cracks[k].y_2, k});
  }
  std::ranges::sort(ends);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size() && ends[j].x - ends[i].x <= reach; ++j)
      if (std::abs(ends[j].y - ends[i].y) <= reach) pairs.push_back({ends[i].crack, ends[j].crack});
  return pairs;
}

struct Sums {
  CrackPath path{};
  double tensile = 0;  // length of its tensile cracks [m]
};

void add(const ObservedCrack& crack, Sums& sums) {
  CrackPath& path = sums.path;
  const auto [x, y] = crack.middle();
  if (path.cracks++ == 0 || crack.opening > path.opening) {
    path.opening = crack.opening;
    path.x = x;
    path.y = y;
  }
  path.slip = std::max(path.slip, std::abs(crack.slip));
  path.length += crack.length();
  if (crack.mode == BondState::kTensileCrack) sums.tensile += crack.length();
  path.mode = 2 * sums.tensile >= path.length ? BondState::kTensileCrack : BondState::kShearCrack;
}

}  // namespace

CrackPaths paths_of(std::span<const ObservedCrack> cracks) {
  const Fragments found = fragments_of(cracks.size(), meeting(cracks));
  std::vector<Sums> sums(found.count());
  for (std::size_t k = 0; k < cracks.size(); ++k)
    if (!cracks[k].debonded) add(cracks[k], sums[found.number[k]]);
  std::vector<std::uint32_t> order, number(sums.size(), 0);
  for (std::uint32_t i = 0; i < sums.size(); ++i)
    if (sums[i].path.cracks > 0) order.push_back(i);
  std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t i) { return sums[i].path.length; });
  CrackPaths all;
  for (const std::uint32_t i : order) {
    all.paths.push_back(sums[i].path);
    number[i] = static_cast<std::uint32_t>(all.paths.size());
  }
  for (const std::uint32_t i : found.number) all.number.push_back(number[i]);
  return all;
}

}  // namespace adit::dem
