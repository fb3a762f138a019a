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
    // Across a spring beams share the point but not the rotation: the beam that begins there gets its own, at
    // the last end the one that ends there.
    if (!joint.segments)
      rotations[joint.node][beams == joint.node ? 0 : 1] = structures.add_rotation(points[joint.node]);
  if (plan.first_held && !plan.path.closed) structures.hold(rotations.front()[1]);
  if (plan.last_held && !plan.path.closed) structures.hold(rotations.back()[0]);

  Lining lining{plan.name,
                plan.path,
                static_cast<std::uint32_t>(structures.beams().size()),
                static_cast<std::uint32_t>(beams),
                plan.section,
                plan.bonded_to,
                plan.spacing,
                plan.joints};
  double dt = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < beams; ++k) {
    const std::size_t next = (k + 1) % nodes;
    const auto p = points[k], q = points[next];
    const Beam beam({p, q}, {rotations[k][1], rotations[next][0]},
                    chord(grid.x[p], grid.y[p], grid.x[q], grid.y[q]), plan.elastic);
    dt = std::min(dt, beam.critical_step());
    const auto fibres = plan.section && !plan.section->elastic ? plan.section->fibres : nullptr;
    plan.follows_chord ? structures.add_member_beam(beam, fibres) : structures.add_beam(beam, fibres);
  }
  if (plan.strength) lining.member = structures.add_member(lining.first_beam, lining.beams, *plan.strength);
  for (const auto& [node, stiffness, yield, segments] : plan.joints) {
    if (segments)
      for (const auto& [beam, end] : beams_at(lining, node))
        structures.add_segment_joint(static_cast<std::uint32_t>(beam), end, segments);
    else if (stiffness > 0)
      structures.add_joint(rotations[node][0], rotations[node][1], stiffness, yield, dt);
  }
  return lining;
}

std::vector<BeamEnd> beams_at(const Lining& lining, std::size_t node) {
  const std::size_t beams = lining.beams;
  std::vector<BeamEnd> found;
  if (lining.path.closed || node > 0) found.push_back({lining.first_beam + (node + beams - 1) % beams, 1});
  if (lining.path.closed || node < beams) found.push_back({lining.first_beam + node, 0});
  return found;
}

namespace {

LiningForces mean(const LiningForces& a, const LiningForces& b) {
  return {0.5 * a.thrust + 0.5 * b.thrust, 0.5 * a.moment + 0.5 * b.moment, 0.5 * a.shear + 0.5 * b.shear};
}

}  // namespace

NodeForces all_forces_at(const Lining& lining, const Structures& structures, std::size_t node) {
  const auto beams = structures.beams().subspan(lining.first_beam, lining.beams);
  const Beam& before = beams[(node + beams.size() - 1) % beams.size()];
  const Beam& after = beams[node % beams.size()];
  const BeamForces of_before = before.forces(), of_after = after.forces();
  const double all = lining.spacing;
  const LiningForces first{all * of_before.thrust, all * of_before.second, all * of_before.shear},
      second{all * of_after.thrust, all * of_after.first, all * of_after.shear};
  if (!lining.path.closed && node == 0) return {{second}, 1};
  if (!lining.path.closed && node == beams.size()) return {{first}, 1};
  if (before.chord().x * after.chord().x + before.chord().y * after.chord().y < kCorner)
    return {{first, second}, 2};
  return {{mean(first, second)}, 1};
}

LiningForces forces_at(const Lining& lining, const Structures& structures, std::size_t node) {
  const auto [forces, count] = all_forces_at(lining, structures, node);
  return count == 2 && std::abs(forces[1].thrust) > std::abs(forces[0].thrust) ? forces[1] : forces[0];
}

}  // namespace adit::fdm
