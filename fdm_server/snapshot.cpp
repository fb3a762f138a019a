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
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    piece.add_points(grid.x[i]);
    piece.add_points(grid.y[i]);
  }
  for (const auto& zone : grid.zones)
    for (const auto point : zone) piece.add_connectivity(static_cast<std::uint32_t>(point));

  auto& at_points = *piece.mutable_point_fields();
  fill_vectors(continuum.ux(), continuum.uy(), new_field(at_points, "displacement_m", 3, grid.x.size()));
  fill_vectors(continuum.vx(), continuum.vy(), new_field(at_points, "velocity_m_per_s", 3, grid.x.size()));

  auto& in_zones = *piece.mutable_cell_fields();
  double* stress = new_field(in_zones, "stress_Pa", 3, grid.zones.size());
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [xx, yy, xy] = continuum.zones().stress(z);
    stress[3 * z] = xx;
    stress[3 * z + 1] = yy;
    stress[3 * z + 2] = xy;
  }
  std::ranges::copy(weights, new_field(in_zones, "weight", 1, grid.zones.size()));
}

void add_peaks(const Peaks& peaks, wire::Piece& piece) {
  protocol::add_peak_fields(peaks.motion(), *piece.mutable_point_fields());
  const auto add = [&](const std::string& name, std::span<const double> values) {
    std::ranges::copy(values, new_field(*piece.mutable_cell_fields(), name, 1, values.size()));
  };
  add("peak_shear_strain", peaks.shear_strain());
  add("peak_largest_principal_stress_Pa", peaks.largest_principal());
  add("peak_smallest_principal_stress_Pa", peaks.smallest_principal());
}

}  // namespace adit::fdm
