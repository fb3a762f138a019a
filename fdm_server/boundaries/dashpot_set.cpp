#include "fdm_server/boundaries/dashpot_set.hpp"

namespace adit::fdm {
namespace {

Symmetric operator*(double length, const Symmetric& c) {
  return {length * c.xx, length * c.xy, length * c.yy};
}

}  // namespace

Dashpot& DashpotSet::at(std::uint32_t point) {
  Dashpot& found = dashpots_[point];
  found.point = point;
  return found;
}

void DashpotSet::add_quiet(const EdgeSet& edges, std::size_t e, const ImpedanceOf& impedance, bool normal,
                           bool shear) {
  for (const EdgeShare& share : edges.shares(e)) {
    const Impedance given = impedance(share.zone);
    const Impedance wanted{normal ? given.normal : 0, shear ? given.shear : 0};
    add(at(share.point), {share.zone, share.length * dashpots(edges[e], wanted)});
  }
}

void DashpotSet::add_springs(const EdgeSet& edges, std::size_t e, const ImpedanceOf& impedance,
                             double source_distance) {
  for (const EdgeShare& share : edges.shares(e))
    add(at(share.point),
        {share.zone, {}, share.length * springs(edges[e], impedance(share.zone).modulus, source_distance)});
}

void DashpotSet::hold(const EdgeSet& edges, std::size_t e, bool x, bool y) {
  for (const EdgeShare& share : edges.shares(e)) add(at(share.point), {share.zone, {}, {}, x, y});
}

void DashpotSet::add_free_field(const FreeFieldColumn& column, const ImpedanceOf& impedance) {
  for (std::size_t k = 0; k < column.edges.size(); ++k) {
    const BoundaryEdge& edge = column.edges[k];
    const Impedance of_side = impedance(edge.zone);
    const Symmetric half = edge.length / 2 * dashpots(edge, of_side);
    const double weight = of_side.normal / impedance(column.zone(k)).normal;  // the column's own is 1
    for (const std::size_t end : {k, k + 1}) {
      Dashpot& point = at(column.side[end]);
      if (!point.field) point.field.emplace();
      FreeFieldLink& link = *point.field;
      add(point, {edge.zone, half});
      link.damping += half;
      link.column_point = column.point(end);
      const std::size_t from = end == k ? 1 : 0;  // the zone lies above its lower end
      link.zones[from] = column.zone(k);
      link.lengths[from] = column.normal_x * weight * edge.length / 2;
    }
  }
}

std::vector<Dashpot> DashpotSet::in_order(const Grid& grid) const {
  std::vector<Dashpot> ordered;
  // The force on a point of the side depends on the mean velocity of its column's point over the step, hence
  // on all forces of that point, its own dashpots included.
  for (const bool of_column : {true, false})
    for (const auto& [point, dashpot] : dashpots_)
      if ((point >= grid.own_points()) == of_column) ordered.push_back(dashpot);
  return ordered;
}

}  // namespace adit::fdm
