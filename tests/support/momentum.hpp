// Linear momentum of a model, from the snapshots of its participants.
#pragma once

#include <array>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/messages/wire.pb.h"

namespace adit::test {

inline const wire::Field& field(const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                                const std::string& name) {
  for (const auto& candidate : fields)
    if (candidate.name() == name) return candidate;
  throw std::out_of_range(name);
}

using Momentum = std::array<double, 2>;  // x, y [N s]

inline void add_momentum(double mass, const wire::Field& velocity, std::uint32_t point, Momentum& sum) {
  for (int direction = 0; direction < 2; ++direction)
    sum[direction] += mass * velocity.values(static_cast<int>(velocity.components() * point) + direction);
}

// Rectangular zones share their weighted mass equally among their corners.
inline void add_momentum_of_grid(const wire::Piece& piece, double density, Momentum& sum) {
  const wire::Field& velocity = field(piece.point_fields(), "velocity_m_per_s");
  const wire::Field& weight = field(piece.cell_fields(), "weight");
  for (int zone = 0; 4 * zone < piece.connectivity_size(); ++zone) {
    const auto from = piece.connectivity(4 * zone),
               to = piece.connectivity(4 * zone + 2);  // opposite corners
    const double area = (piece.points(2 * to) - piece.points(2 * from)) *
                        (piece.points(2 * to + 1) - piece.points(2 * from + 1));
    for (int corner = 0; corner < 4; ++corner)
      add_momentum(density * area / 4 * weight.values(zone), velocity, piece.connectivity(4 * zone + corner),
                   sum);
  }
}

// Particles stand for their hexagonal cells.
inline void add_momentum_of_particles(const wire::Piece& piece, double density, Momentum& sum) {
  const wire::Field& velocity = field(piece.point_fields(), "velocity_m_per_s");
  const wire::Field& weight = field(piece.point_fields(), "weight");
  const wire::Field& radius = field(piece.point_fields(), "radius_m");
  for (int i = 0; 2 * i < piece.points_size(); ++i)
    add_momentum(density * 2 * std::numbers::sqrt3 * radius.values(i) * radius.values(i) * weight.values(i),
                 velocity, static_cast<std::uint32_t>(i), sum);
}

// The momentum of all models together, which have the same density [kg/m^3]. Pieces of a region begin with
// its name.
inline Momentum momentum(const std::vector<wire::Snapshot>& snapshots, double density) {
  Momentum sum{};
  for (const wire::Snapshot& snapshot : snapshots)
    for (const wire::Piece& piece : snapshot.pieces()) {
      if (piece.name().ends_with("grid")) add_momentum_of_grid(piece, density, sum);
      if (piece.name().ends_with("particles")) add_momentum_of_particles(piece, density, sum);
    }
  return sum;
}

}  // namespace adit::test
