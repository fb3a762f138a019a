#include "dem_server/observe/pieces.hpp"

namespace adit::dem {
namespace {

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

}  // namespace

google::protobuf::RepeatedField<double>& add_field(Fields& fields, const std::string& name,
                                                   unsigned components) {
  wire::Field& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  return *field.mutable_values();
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

}  // namespace adit::dem
