#include "dem_server/snapshot.hpp"

#include <string>
#include <vector>

namespace adit::dem {
namespace {

using Fields = google::protobuf::RepeatedPtrField<wire::Field>;

google::protobuf::RepeatedField<double>& add_field(Fields& fields, const std::string& name,
                                                   unsigned components) {
  wire::Field& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  return *field.mutable_values();
}

void add_scalars(Fields& fields, const std::string& name, const auto& values) {
  auto& to = add_field(fields, name, 1);
  to.Reserve(static_cast<int>(values.size()));
  for (const auto value : values) to.Add(static_cast<double>(value));
}

void add_vectors(Fields& fields, const std::string& name, const std::vector<double>& x,
                 const std::vector<double>& y) {
  auto& to = add_field(fields, name, 3);
  to.Reserve(static_cast<int>(3 * x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    to.Add(x[i]);
    to.Add(y[i]);
    to.Add(0.0);
  }
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

wire::Piece& add_piece(const std::string& name, wire::Piece::Shape shape, const Particles& p,
                       wire::Snapshot& snapshot) {
  wire::Piece& piece = *snapshot.add_pieces();
  piece.set_name(name);
  piece.set_shape(shape);
  piece.mutable_points()->Reserve(static_cast<int>(2 * p.size()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    piece.add_points(p.x[i]);
    piece.add_points(p.y[i]);
  }
  add_vectors(*piece.mutable_point_fields(), "displacement_m", difference(p.ux, p.settled_x),
              difference(p.uy, p.settled_y));
  return piece;
}

}  // namespace

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
