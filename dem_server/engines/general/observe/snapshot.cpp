#include "dem_server/engines/general/observe/snapshot.hpp"

#include <vector>

#include "dem_server/engines/general/observe/branches.hpp"
#include "dem_server/engines/general/observe/fragments.hpp"
#include "dem_server/participant/pieces.hpp"

namespace adit::dem {
namespace {

// Lines of the pairs of which `shown` is true, and their forces.
template <class Shown>
wire::Piece& add_pairs(const std::string& name, const Solver& solver, const Pairs& pairs, Shown&& shown,
                       wire::Snapshot& snapshot) {
  wire::Piece& piece = add_piece(name, wire::Piece::LINES, solver.particles(), snapshot);
  std::vector<double> normal, shear, moment;
  for (std::uint32_t k = 0; k < pairs.size(); ++k) {
    const PairState s = state_of(k, solver.laws(), solver.particles(), pairs);
    if (!shown(s)) continue;
    piece.add_connectivity(pairs.first[k]);
    piece.add_connectivity(pairs.second[k]);
    normal.push_back(s.cement_normal + s.contact_normal);
    shear.push_back(s.shear);
    moment.push_back(s.moment);
  }
  Fields& fields = *piece.mutable_cell_fields();
  add_scalars(fields, "normal_force_N", normal);
  add_scalars(fields, "shear_force_N", shear);
  if (pairs.cemented()) add_scalars(fields, "moment_Nm", moment);
  return piece;
}

}  // namespace

void write_snapshot(const Solver& solver, const Model& model, wire::Snapshot& snapshot) {
  const Particles& p = solver.particles();
  snapshot.Clear();
  snapshot.mutable_pieces()->Reserve(4);  // references to pieces stay
  wire::Piece& particles = add_piece("particles", wire::Piece::VERTICES, p, snapshot);
  for (std::uint32_t i = 0; i < p.size(); ++i) particles.add_connectivity(i);
  const Pairs& bonds = solver.bonds();
  wire::Piece& lines = add_pairs(
      "bonds", solver, bonds, [](const PairState&) { return true; }, snapshot);
  add_scalars(*lines.mutable_cell_fields(), "state", bonds.state);
  add_scalars(*lines.mutable_cell_fields(), "weight", bonds.weight);
  add_pairs(
      "contacts", solver, solver.contacts(), [](const PairState& s) { return s.touches; }, snapshot);

  if (!solver.springs().springs().empty()) {
    wire::Piece& springs = add_piece("springs", wire::Piece::LINES, p, snapshot);
    for (const Spring& spring : solver.springs().springs()) {
      springs.add_connectivity(spring.first);
      springs.add_connectivity(spring.second);
    }
    add_scalars(*springs.mutable_cell_fields(), "force_N", solver.springs().forces());
  }

  Fields& fields = *particles.mutable_point_fields();
  add_vectors(fields, "velocity_m_per_s", p.vx, p.vy);
  add_scalars(fields, "spin_rad_per_s", p.spin);
  add_scalars(fields, "radius_m", solver.radius());
  add_scalars(fields, "weight", p.weight);
  add_scalars(fields, "id", p.id);
  add_scalars(fields, "group", model.group);
  add_scalars(fields, "coordination", coordination_of(p.size(), touching_discs(solver)));
  add_scalars(fields, "fragment", fragments_of(p.size(), whole_bonds(solver)).number);
}

}  // namespace adit::dem
