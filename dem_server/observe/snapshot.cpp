#include "dem_server/observe/snapshot.hpp"

#include <vector>

#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/fragments.hpp"
#include "dem_server/observe/pieces.hpp"

namespace adit::dem {
namespace {

void add_line(std::uint32_t first, std::uint32_t second, wire::Piece& piece) {
  piece.add_connectivity(first);
  piece.add_connectivity(second);
}

void add_bonds(const Observable& observed, wire::Snapshot& snapshot) {
  wire::Piece& piece = add_piece("bonds", wire::Piece::LINES, observed.particles(), snapshot);
  std::vector<double> normal, shear, moment, weight;
  std::vector<BondState> state;
  observed.for_each_bond([&](const ObservedPair& bond) {
    add_line(bond.first, bond.second, piece);
    normal.push_back(bond.normal);
    shear.push_back(bond.shear);
    moment.push_back(bond.moment);
    state.push_back(bond.state);
    weight.push_back(bond.weight);
  });
  Fields& fields = *piece.mutable_cell_fields();
  add_scalars(fields, "normal_force_N", normal);
  add_scalars(fields, "shear_force_N", shear);
  add_scalars(fields, "moment_Nm", moment);
  add_scalars(fields, "state", state);
  add_scalars(fields, "weight", weight);
}

void add_contacts(const Observable& observed, wire::Snapshot& snapshot) {
  wire::Piece& piece = add_piece("contacts", wire::Piece::LINES, observed.particles(), snapshot);
  std::vector<double> normal, shear;
  observed.for_each_contact([&](const ObservedPair& contact) {
    add_line(contact.first, contact.second, piece);
    normal.push_back(contact.normal);
    shear.push_back(contact.shear);
  });
  add_scalars(*piece.mutable_cell_fields(), "normal_force_N", normal);
  add_scalars(*piece.mutable_cell_fields(), "shear_force_N", shear);
}

void add_springs(const Observable& observed, wire::Snapshot& snapshot) {
  const auto springs = observed.springs();
  if (springs.empty()) return;
  wire::Piece& piece = add_piece("springs", wire::Piece::LINES, observed.particles(), snapshot);
  std::vector<double> force;
  for (const SpringForce& spring : springs) {
    add_line(spring.first, spring.second, piece);
    force.push_back(spring.force);
  }
  add_scalars(*piece.mutable_cell_fields(), "force_N", force);
}

void add_particles(const Observable& observed, wire::Snapshot& snapshot) {
  const Particles& p = observed.particles();
  wire::Piece& piece = add_piece("particles", wire::Piece::VERTICES, p, snapshot);
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (p.is_there(i)) piece.add_connectivity(i);
  Fields& fields = *piece.mutable_point_fields();
  add_vectors(fields, "velocity_m_per_s", p.vx, p.vy);
  add_scalars(fields, "spin_rad_per_s", p.spin);
  add_scalars(fields, "radius_m", p.radius);
  add_scalars(fields, "weight", p.weight);
  add_scalars(fields, "id", p.id);
  add_scalars(fields, "group", observed.group());
  add_scalars(fields, "coordination", coordination_of(p.size(), touching_particles(observed)));
  add_scalars(fields, "fragment", fragments_of(p.size(), whole_bonds(observed)).number);
}

}  // namespace

void write_snapshot(const Observable& observed, wire::Snapshot& snapshot) {
  snapshot.Clear();
  add_particles(observed, snapshot);
  add_bonds(observed, snapshot);
  add_contacts(observed, snapshot);
  add_springs(observed, snapshot);
}

}  // namespace adit::dem
