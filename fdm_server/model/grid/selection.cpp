#include "fdm_server/model/grid/selection.hpp"

#include <algorithm>

#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {
namespace {

const Group& find_group(const Grid& grid, const std::string& name, const std::string& path) {
  const auto group = std::ranges::find(grid.groups, name, &Group::name);
  if (group != grid.groups.end()) return *group;
  std::vector<std::string> names;
  std::string list;
  for (const auto& [known, zones, edges] : grid.groups) {
    names.push_back(known);
    list += (list.empty() ? "`" : ", `") + known + "`";
  }
  throw protocol::UserError(
      path + ".group", "is `" + name + "`, but the continuum has " +
                           (list.empty() ? "no groups; name its blocks, or select by place"
                                         : "only the groups " + list + protocol::did_you_mean(name, names)));
}

std::vector<bool> points_of(const Group& group, const Grid& grid) {
  std::vector<bool> chosen(grid.x.size(), false);
  for (const auto zone : group.zones)
    for (const auto point : grid.zones[zone]) chosen[point] = true;
  for (const auto& edge : group.edges) chosen[edge.from] = chosen[edge.to] = true;
  return chosen;
}

std::vector<Edge> edges_of(const Group& group, const Grid& grid) {
  if (!group.edges.empty()) return group.edges;
  std::vector<Edge> sides;
  std::ranges::copy_if(grid.boundary, std::back_inserter(sides),
                       [&](const Edge& edge) { return std::ranges::binary_search(group.zones, edge.zone); });
  return sides;
}

}  // namespace

std::vector<std::uint32_t> select_points(const Grid& grid, const scene::Area& area, const std::string& path) {
  const auto candidates = area.has_group() ? points_of(find_group(grid, area.group(), path), grid)
                                           : std::vector<bool>(grid.x.size(), true);
  const protocol::Places places(area, path, tolerance(grid));
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < grid.own_points(); ++i)
    if (candidates[i] && places.hold(grid.x[i], grid.y[i])) chosen.push_back(i);
  if (chosen.empty()) protocol::refuse_empty(path, "grid points");
  return chosen;
}

std::vector<std::uint32_t> zones_in(const Grid& grid, const scene::Area& area, const std::string& path) {
  const protocol::Places places(area, path, tolerance(grid));
  std::vector<std::uint32_t> chosen;
  const auto consider = [&](std::uint32_t zone) {
    const auto [x, y] = centroid(corners(grid, zone));
    if (places.hold(x, y)) chosen.push_back(zone);
  };
  if (area.has_group())
    std::ranges::for_each(find_group(grid, area.group(), path).zones, consider);
  else
    for (std::uint32_t zone = 0; zone < grid.zones.size() - grid.own_corners.size(); ++zone) consider(zone);
  return chosen;
}

std::vector<std::uint32_t> select_zones(const Grid& grid, const scene::Area& area, const std::string& path) {
  std::vector<std::uint32_t> chosen = zones_in(grid, area, path);
  if (chosen.empty()) protocol::refuse_empty(path, "zones");
  return chosen;
}

std::vector<Edge> select_edges(const Grid& grid, const scene::Area& area, const std::string& path) {
  auto chosen = area.has_group() ? edges_of(find_group(grid, area.group(), path), grid) : grid.boundary;
  const protocol::Places places(area, path, tolerance(grid));
  const auto holds = [&](std::int32_t point) { return places.hold(grid.x[point], grid.y[point]); };
  std::erase_if(chosen, [&](const Edge& edge) { return !holds(edge.from) || !holds(edge.to); });
  if (chosen.empty())
    throw protocol::UserError(
        path,
        "holds no whole edge of the continuum's boundary; widen it so that both ends of at "
        "least one zone's outer edge lie inside");
  return chosen;
}

}  // namespace adit::fdm
