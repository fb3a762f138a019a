#include "fdm_server/supports/lining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::fdm {

std::size_t nearest_node(const geometry::Point& place, const Path& lining, const Grid& grid,
                         const std::string& path) {
  const auto distance = [&](std::size_t node) {
    const auto point = lining.points[node];
    return std::hypot(grid.x[point] - place.x, grid.y[point] - place.y);
  };
  std::size_t nearest = 0;
  for (std::size_t node = 1; node < lining.points.size(); ++node)
    if (distance(node) < distance(nearest)) nearest = node;
  const auto next = lining.points[nearest == 0 ? 1 : nearest - 1], here = lining.points[nearest];
  const double beam = std::hypot(grid.x[next] - grid.x[here], grid.y[next] - grid.y[here]);
  // A place on the lining is at most half a beam from a node; the rest is room for beams of unequal length
  // and for the curve between their nodes.
  if (!(distance(nearest) <= 0.6 * beam))
    throw protocol::UserError(
        path, fmt::format("lies at ({:.6g}, {:.6g}) m, {:.3g} m from the lining's nearest node; put it on "
                          "the lining",
                          place.x, place.y, distance(nearest)));
  return nearest;
}

Lining add_lining(const LiningPlan& plan, const Grid& grid, Structures& structures) {
  const auto& points = plan.path.points;
  const std::size_t nodes = points.size(), beams = plan.path.closed ? nodes : nodes - 1;
  // Of the beam that ends at a node, of that which begins.
  std::vector<std::array<std::uint32_t, 2>> rotations;
  for (const auto point : points) {
    const auto shared = structures.shared_rotation(point);
    rotations.push_back({shared, shared});
  }
  for (const auto& joint : plan.joints)
    // Across a joint beams share the point but not the rotation: the beam that begins there gets its own, at
    // the last end the one that ends there.
    rotations[joint.node][beams == joint.node ? 0 : 1] = structures.add_rotation(points[joint.node]);
  if (plan.first_held && !plan.path.closed) structures.hold(rotations.front()[1]);
  if (plan.last_held && !plan.path.closed) structures.hold(rotations.back()[0]);

  Lining lining{plan.name, plan.path, static_cast<std::uint32_t>(structures.beams().size()),
                static_cast<std::uint32_t>(beams)};
  double dt = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < beams; ++k) {
    const std::size_t next = (k + 1) % nodes;
    const auto p = points[k], q = points[next];
    const Beam beam({p, q}, {rotations[k][1], rotations[next][0]},
                    chord(grid.x[p], grid.y[p], grid.x[q], grid.y[q]), plan.section);
    dt = std::min(dt, beam.critical_step());
    structures.add_beam(beam);
  }
  for (const auto& [node, stiffness, yield] : plan.joints)
    if (stiffness > 0) structures.add_joint(rotations[node][0], rotations[node][1], stiffness, yield, dt);
  return lining;
}

LiningForces forces_at(const Lining& lining, const Structures& structures, std::size_t node) {
  const auto beams = structures.beams().subspan(lining.first_beam, lining.beams);
  const bool has_before = lining.path.closed || node > 0, has_after = node < beams.size();
  LiningForces sum{};
  const auto add = [&](const BeamForces& beam, double moment) {
    const double share = has_before && has_after ? 0.5 : 1;
    sum.thrust += share * beam.thrust;
    sum.moment += share * moment;
    sum.shear += share * beam.shear;
  };
  if (has_before) {
    const auto before = beams[(node + beams.size() - 1) % beams.size()].forces();
    add(before, before.second);
  }
  if (has_after) {
    const auto after = beams[node].forces();
    add(after, after.first);
  }
  return sum;
}

}  // namespace adit::fdm
