#include "fdm_server/snapshot.hpp"

#include <algorithm>
#include <string>

namespace adit::fdm {
namespace {

// A field of `rows` rows of zeros, to be filled by place.
double* new_field(google::protobuf::RepeatedPtrField<wire::Field>& fields, const std::string& name,
                  int components, std::size_t rows) {
  auto& field = *fields.Add();
  field.set_name(name);
  field.set_components(components);
  field.mutable_values()->Resize(components * static_cast<int>(rows), 0.0);
  return field.mutable_values()->mutable_data();
}

void fill_vectors(std::span<const double> x, std::span<const double> y, double* values) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    values[3 * i] = x[i];
    values[3 * i + 1] = y[i];
  }
}

}  // namespace

void fill_snapshot(const Grid& grid, const Continuum& continuum, std::span<const double> weights,
                   wire::Snapshot& snapshot) {
  snapshot.Clear();
  auto& piece = *snapshot.add_pieces();
  piece.set_name("grid");
  piece.set_shape(wire::Piece::QUADS);
  const std::size_t points = grid.own_points(), zones = grid.zones.size() - grid.own_corners.size();
  for (std::size_t i = 0; i < points; ++i) {
    piece.add_points(grid.x[i]);
    piece.add_points(grid.y[i]);
  }
  for (std::size_t z = 0; z < zones; ++z)
    for (const auto point : grid.zones[z]) piece.add_connectivity(static_cast<std::uint32_t>(point));

  auto& at_points = *piece.mutable_point_fields();
  fill_vectors(continuum.ux().first(points), continuum.uy(),
               new_field(at_points, "displacement_m", 3, points));
  fill_vectors(continuum.vx().first(points), continuum.vy(),
               new_field(at_points, "velocity_m_per_s", 3, points));

  auto& in_zones = *piece.mutable_cell_fields();
  double* stress = new_field(in_zones, "stress_Pa", 3, zones);
  for (std::size_t z = 0; z < zones; ++z) {
    const auto [xx, yy, xy] = continuum.zones().stress(z);
    stress[3 * z] = xx;
    stress[3 * z + 1] = yy;
    stress[3 * z + 2] = xy;
  }
  std::ranges::copy(weights.first(zones), new_field(in_zones, "weight", 1, zones));
}

}  // namespace adit::fdm
