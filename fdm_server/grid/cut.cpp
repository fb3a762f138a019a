#include "fdm_server/grid/cut.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace adit::fdm {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// A zone at a point, with the points before and after it around the zone.
struct ZoneAtPoint {
  std::uint32_t zone, before, after;
};

// Numbers of the sets of zones around a point that sides without a cut join, each set by its first zone.
std::vector<std::size_t> joined(std::span<const ZoneAtPoint> zones, std::uint32_t point,
                                const std::set<Pair>& cuts) {
  std::vector<std::size_t> set(zones.size());
  std::iota(set.begin(), set.end(), 0u);
  const auto joins = [&](std::uint32_t a, std::uint32_t b) {
    return a == b && !cuts.contains(std::minmax(point, a));
  };
  for (std::size_t i = 0; i < zones.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (joins(zones[i].before, zones[k].after) || joins(zones[i].after, zones[k].before)) {
        const auto [low, high] = std::minmax(set[i], set[k]);
        std::ranges::replace(set, high, low);
      }
  return set;
}

}  // namespace

void cut(Grid& grid, std::span<const Side> sides, const std::vector<bool>& kept) {
  std::set<Pair> cuts;
  std::map<std::uint32_t, std::vector<ZoneAtPoint>> around;
  std::vector<std::uint32_t> order;  // along the cuts, so that their new points are neighbours
  for (const auto& [a, b] : sides) {
    cuts.insert(std::minmax(a, b));
    for (const auto point : {a, b})
      if (!kept[point] && around.try_emplace(point).second) order.push_back(point);
  }
  for (std::uint32_t z = 0; z < grid.zones.size(); ++z)
    for (std::uint32_t c = 0; c < 4; ++c)
      if (const auto found = around.find(static_cast<std::uint32_t>(grid.zones[z][c])); found != around.end())
        found->second.push_back({z, static_cast<std::uint32_t>(grid.zones[z][(c + 3) % 4]),
                                 static_cast<std::uint32_t>(grid.zones[z][(c + 1) % 4])});

  std::map<Pair, std::int32_t> own;  // the new point of a zone in the place of an old one
  for (const auto point : order) {
    const auto& zones = around.at(point);
    const auto set = joined(zones, point, cuts);
    std::map<std::size_t, std::int32_t> copies;
    for (std::size_t i = 0; i < zones.size(); ++i) {
      if (set[i] == set[0]) continue;
      const auto [copy, added] = copies.try_emplace(set[i], static_cast<std::int32_t>(grid.x.size()));
      if (added) {
        grid.x.push_back(grid.x[point]);
        grid.y.push_back(grid.y[point]);
        grid.double_of.push_back(point);
      }
      own[{zones[i].zone, point}] = copy->second;
    }
  }
  for (const auto& [of, copy] : own)
    std::ranges::replace(grid.zones[of.first], static_cast<std::int32_t>(of.second), copy);
  const auto follow = [&](std::vector<Edge>& edges) {
    for (auto& [from, to, zone] : edges)
      for (auto* point : {&from, &to})
        if (const auto found = own.find({zone, static_cast<std::uint32_t>(*point)}); found != own.end())
          *point = found->second;
  };
  follow(grid.boundary);
  for (Group& group : grid.groups) follow(group.edges);
}

Grid welded(Grid grid) {
  for (auto& zone : grid.zones)
    for (auto& point : zone) point = static_cast<std::int32_t>(grid.place(static_cast<std::uint32_t>(point)));
  return grid;
}

}  // namespace adit::fdm
