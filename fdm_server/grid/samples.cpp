#include "fdm_server/grid/samples.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdm_server/grid/edges.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

// The Jacobian of the bilinear map at the corners; between them it is bilinear.
std::array<double, 4> jacobians(const Corners& c) {
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4, last = (i + 3) % 4;
    result[i] =
        ((c.x[next] - c.x[i]) * (c.y[last] - c.y[i]) - (c.x[last] - c.x[i]) * (c.y[next] - c.y[i])) / 4;
  }
  return result;
}

}  // namespace

std::vector<double> sample_points(const Grid& grid) {
  const auto edges = number_edges(grid);
  std::vector<double> points;
  points.reserve(2 * (grid.x.size() + edges.list.size() + grid.zones.size()));
  const auto add = [&points](double x, double y) {
    points.push_back(x);
    points.push_back(y);
  };
  for (std::size_t i = 0; i < grid.x.size(); ++i) add(grid.x[i], grid.y[i]);
  for (const auto& [from, to, zone] : edges.list)
    add((grid.x[from] + grid.x[to]) / 2, (grid.y[from] + grid.y[to]) / 2);
  for (const auto& [a, b, c, d] : grid.zones)
    add((grid.x[a] + grid.x[b] + grid.x[c] + grid.x[d]) / 4,
        (grid.y[a] + grid.y[b] + grid.y[c] + grid.y[d]) / 4);
  return points;
}

std::vector<double> zone_weights(const Grid& grid, std::span<const double> samples, double floor) {
  const auto edges = number_edges(grid);
  const auto at_points = samples.data(), at_edges = at_points + grid.x.size(),
             in_zones = at_edges + edges.list.size();
  const std::size_t count = grid.x.size() + edges.list.size() + grid.zones.size();
  if (samples.size() != count)
    throw protocol::RequestError(fmt::format("got {} weights for {} sample points", samples.size(), count));
  std::vector<double> weights(grid.zones.size());
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto j = jacobians(corners(grid, z));
    const double middle = (j[0] + j[1] + j[2] + j[3]) / 4;
    double sum = 16 * middle * in_zones[z];
    bool exists = in_zones[z] != 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const double corner = at_points[grid.zones[z][c]], edge = at_edges[edges.of_zone[z][c]];
      sum += j[c] * corner + 2 * (j[c] + j[(c + 1) % 4]) * edge;
      exists = exists || corner != 0 || edge != 0;
    }
    weights[z] = exists ? std::max(sum / (36 * middle), floor) : 0.0;
  }
  return weights;
}

std::vector<std::array<double, 4>> side_shares(const Grid& grid, std::span<const double> samples,
                                               std::span<const double> weights) {
  const auto edges = number_edges(grid);
  const auto at_edges = samples.subspan(grid.x.size(), edges.list.size());
  std::vector<double> share(at_edges.begin(), at_edges.end());
  for (std::size_t z = 0; z < weights.size(); ++z)
    if (weights[z] == 0)
      for (const auto e : edges.of_zone[z]) share[e] = 0;
  std::vector<std::array<double, 4>> shares;
  for (std::size_t z = 0; z < weights.size(); ++z) {
    if (weights[z] == 0) continue;
    auto& sides = shares.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) sides[c] = share[edges.of_zone[z][c]];
  }
  return shares;
}

std::vector<Corners> drop_slivers(const Grid& grid, std::span<const double> samples,
                                  std::vector<double>& weights) {
  constexpr double kLight = 0.01;
  const auto in_zones = samples.last(grid.zones.size());
  std::vector<Corners> slivers;
  for (std::size_t z = 0; z < weights.size(); ++z) {
    if (in_zones[z] != 0 || weights[z] == 0 || weights[z] >= kLight) continue;
    weights[z] = 0;
    slivers.push_back(corners(grid, z));
  }
  return slivers;
}

}  // namespace adit::fdm
