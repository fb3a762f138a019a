#include "fdm_server/model/boundaries/base.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "fdm_server/model/grid/selection.hpp"
#include "protocol/motion/velocity_history.hpp"

namespace adit::fdm {
namespace {

// A point of the base: where the motion meets it, and the load of a unit outcrop velocity or stress along the
// direction, and across it.
struct BasePoint {
  double x;
  Vector load, across;
};

// The edges that the scene names, or those at the lowest level.
std::vector<std::size_t> base_edges(const scene::Base& base, const EdgeSet& edges) {
  const Grid& grid = edges.grid();
  if (base.has_where()) {
    const std::string path = kBasePath + ".where";
    return edges.numbers(select_edges(grid, base.where(), path), path);
  }
  double bottom = HUGE_VAL;
  for (const BoundaryEdge& edge : edges.outline()) bottom = std::min(bottom, grid.y[edge.from]);
  scene::Area area;
  area.set_y_max(bottom);
  return edges.numbers(select_edges(grid, area, kBasePath), kBasePath);
}

Vector column_of(const Symmetric& c, Axis axis) {
  return axis == Axis::kX ? Vector{c.xx, c.xy} : Vector{c.xy, c.yy};
}

// Along the direction of the base, across it.
std::pair<Axis, Axis> axes_of(const scene::Base& base) {
  return base.direction() == scene::Base::X ? std::pair{Axis::kX, Axis::kY} : std::pair{Axis::kY, Axis::kX};
}

std::map<std::uint32_t, BasePoint> base_points(const scene::Base& base, const EdgeSet& edges,
                                               std::span<const std::size_t> chosen,
                                               const ImpedanceOf& impedance) {
  const Symmetric unit_stress{1, 0, 1};
  const auto [along, across] = axes_of(base);
  std::map<std::uint32_t, BasePoint> points;
  for (const std::size_t e : chosen)
    for (const EdgeShare& share : edges.shares(e)) {
      const Symmetric c = base.has_stress() ? unit_stress : dashpots(edges[e], impedance(share.zone));
      BasePoint& point = points.try_emplace(share.point, BasePoint{share.x, {}, {}}).first->second;
      for (auto [load, axis] : {std::pair{&point.load, along}, {&point.across, across}}) {
        const Vector per_metre = column_of(c, axis);
        load->x += share.length * per_metre.x;
        load->y += share.length * per_metre.y;
      }
    }
  return points;
}

}  // namespace

BaseActions resolve_base(const scene::Base& base, const BaseAccelerations& accelerations, EdgeSet& edges,
                         const ImpedanceOf& impedance, DashpotSet& dashpots) {
  const bool compliant = base.kind() == scene::Base::COMPLIANT;
  const auto chosen = base_edges(base, edges);
  for (const std::size_t e : chosen) {
    edges.claim(e, kBasePath, base.has_where() ? kBasePath + ".where" : kBasePath);
    if (!compliant) continue;
    dashpots.add_quiet(edges, e, impedance, true, true);
    dashpots.hold(edges, e, true, true);
  }
  const auto points = base_points(base, edges, chosen, impedance);
  std::vector<double> places;
  for (const auto& [number, point] : points) places.push_back(point.x);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto histories = base_histories(base, places, accelerations.along);
  const TimeFactor history_across =
      base.has_across() ? TimeFactor(motion::VelocityHistory(accelerations.across.acting())) : nullptr;

  const auto [along, across] = axes_of(base);
  BaseActions actions{chosen, {}, {}};
  for (const TimeFactor& history : histories) {
    if (compliant)
      actions.loads.push_back({{}, {}, {}, history});
    else
      actions.motions.push_back({{}, along, 1, history});
  }
  PrescribedMotion motion_across{{}, across, 0, [](double) { return 1.0; }};
  if (history_across) motion_across = {{}, across, 1, history_across};
  Load load_across{{}, {}, {}, history_across};
  for (const auto& [number, point] : points) {
    const auto place = std::ranges::lower_bound(places, point.x) - places.begin();
    const std::size_t k = histories.size() == 1 ? 0 : static_cast<std::size_t>(place);
    if (compliant) {
      Load& load = actions.loads[k];
      load.points.push_back(number);
      load.fx.push_back(point.load.x);
      load.fy.push_back(point.load.y);
      load_across.points.push_back(number);
      load_across.fx.push_back(point.across.x);
      load_across.fy.push_back(point.across.y);
    } else {
      actions.motions[k].points.push_back(number);
      motion_across.points.push_back(number);
    }
  }
  if (!compliant) actions.motions.push_back(std::move(motion_across));
  if (compliant && history_across) actions.loads.push_back(std::move(load_across));
  return actions;
}

}  // namespace adit::fdm
