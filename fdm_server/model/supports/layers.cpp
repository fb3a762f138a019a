#include "fdm_server/model/supports/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

double thickness(const scene::Lining& lining, const std::string& path) {
  require(lining.has_section() || lining.has_thickness(), path + ".on",
          "joins linings of which `" + lining.name() +
              "` has no thickness, so that their distance is unknown; give it `thickness` or `section`");
  return lining.has_section() ? lining.section().thickness() : lining.thickness();
}

}  // namespace

std::vector<int> read_layers(const SceneLinings& linings) {
  std::vector<std::string> names;
  for (const auto& lining : linings) names.push_back(lining.name());
  std::vector<int> below(names.size(), -1);
  for (int i = 0; i < linings.size(); ++i) {
    if (!linings[i].has_on()) continue;
    const auto path = fmt::format("continuum.linings[{}].on", i);
    const auto found = std::ranges::find(names, linings[i].on());
    const auto number = static_cast<int>(found - names.begin());
    require(found != names.end() && number != i, path,
            fmt::format("is `{}`, which is no other lining{}; name the lining that this one lies on",
                        linings[i].on(), protocol::did_you_mean(linings[i].on(), names)));
    require(
        linings[number].stage() <= linings[i].stage(), path,
        fmt::format("is `{}` of stage {}, which is not there yet in stage {}; give this lining that stage "
                    "or a later one",
                    linings[i].on(), linings[number].stage(), linings[i].stage()));
    below[static_cast<std::size_t>(i)] = number;
  }
  for (std::size_t i = 0; i < below.size(); ++i) {
    std::size_t steps = 0;
    for (int at = below[i]; at >= 0; at = below[static_cast<std::size_t>(at)])
      require(++steps < below.size(), fmt::format("continuum.linings[{}].on", i),
              "leads back to the lining itself; let one of them lie on the ground");
  }
  return below;
}

std::vector<std::size_t> from_the_ground(const std::vector<int>& below) {
  const auto depth = [&](std::size_t i) {
    int layers = 0;
    for (int at = below[i]; at >= 0; at = below[static_cast<std::size_t>(at)]) ++layers;
    return layers;
  };
  std::vector<std::size_t> order(below.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, depth);
  return order;
}

Path on_points_of(const LiningPlan& below, const Path& wanted, const Grid& grid, const std::string& path) {
  std::map<std::uint32_t, std::uint32_t> points;
  for (const auto point : below.path.points) points[grid.place(point)] = point;
  Path found = wanted;
  for (auto& point : found.points) {
    const auto at = points.find(grid.place(point));
    require(at != points.end(), path,
            fmt::format("leaves `{}` at ({:.6g}, {:.6g}) m; let it follow that lining, or leave `along` out",
                        below.name, grid.x[point], grid.y[point]));
    point = at->second;
  }
  return found;
}

double between_axes(const scene::Lining& below, const scene::Lining& layer, const std::string& path) {
  return (thickness(below, path) + thickness(layer, path)) / 2;
}

}  // namespace adit::fdm
