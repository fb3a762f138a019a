#include "dem_server/participant/snapshot.hpp"

#include <vector>

#include "dem_server/participant/pieces.hpp"

namespace adit::dem {

void write_snapshot(const Assembly& assembly, wire::Snapshot& snapshot) {
  const Particles& p = assembly.particles;
  const Bonds& b = assembly.bonds;
  snapshot.Clear();

  wire::Piece& particles = add_piece("particles", wire::Piece::VERTICES, p, snapshot);
  for (std::uint32_t i = 0; i < p.size(); ++i) particles.add_connectivity(i);
  Fields& point_fields = *particles.mutable_point_fields();
  add_vectors(point_fields, "velocity_m_per_s", p.vx, p.vy);
  add_scalars(point_fields, "spin_rad_per_s", p.spin);
  add_scalars(point_fields, "radius_m", std::vector<double>(p.size(), b.rest_length / 2));
  add_scalars(point_fields, "weight", p.weight);
  add_scalars(point_fields, "id", p.id);

  wire::Piece& bonds = add_piece("bonds", wire::Piece::LINES, p, snapshot);
  for (std::size_t k = 0; k < b.size(); ++k) {
    bonds.add_connectivity(b.first[k]);
    bonds.add_connectivity(b.second[k]);
  }
  Fields& cell_fields = *bonds.mutable_cell_fields();
  add_scalars(cell_fields, "normal_force_N", b.normal_force);
  add_scalars(cell_fields, "shear_force_N", b.shear_force);
  add_scalars(cell_fields, "state", b.state);
  add_scalars(cell_fields, "weight", b.weight);
}

}  // namespace adit::dem
