// The state as pieces that a viewer can draw.
#pragma once

#include <string>
#include <vector>

#include "dem_server/lining/envelope.hpp"
#include "dem_server/lining/use_peaks.hpp"
#include "dem_server/observe/joint_peaks.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

// Pieces of a snapshot over particles (wire.proto).
using Fields = google::protobuf::RepeatedPtrField<wire::Field>;

google::protobuf::RepeatedField<double>& add_field(Fields& fields, const std::string& name,
                                                   unsigned components);

void add_scalars(Fields& fields, const std::string& name, const auto& values) {
  auto& to = add_field(fields, name, 1);
  to.Reserve(static_cast<int>(values.size()));
  for (const auto value : values) to.Add(static_cast<double>(value));
}

// The vectors have three components; the third is 0.
void add_vectors(Fields& fields, const std::string& name, const std::vector<double>& x,
                 const std::vector<double>& y);

// Over the particles' places at rest, with their displacement_m since time began.
wire::Piece& add_piece(const std::string& name, wire::Piece::Shape shape, const Particles& particles,
                       wire::Snapshot& snapshot);

// Piece "particles": displacement_m, velocity_m_per_s (three components), spin_rad_per_s, radius_m, weight,
// id, group, stress_Pa (xx, yy, xy), coordination (bonds and contacts), fragment. Piece "bonds", over the
// same points: normal_force_N, shear_force_N, moment_Nm (unweighted), state (0 intact, 1 tensile crack, 2
// shear crack), weight, and of facets, which are then all bonds, opening_m and slip_m. Piece "contacts", of
// what touches and was never joined: normal_force_N, shear_force_N. Piece "springs", where there are any:
// force_N, opening_m, broken (0 or 1). Displacements at the last step n since time began, velocities of n
// + 1/2.
void write_snapshot(const Observable& observed, wire::Snapshot& snapshot);

// Piece "sections", where there are any, at their middles: displacement_m, thrust_N, moment_Nm, shear_N, and
// of each largest_… and smallest_… over the times that were looked at. Where any has a strength also
// utilisation, shear_utilisation, moment_ratio and the largest, peak_…; 0 of those without.
void add_sections(const Observable& observed, const Sections& sections, const Envelope& envelope,
                  const UsePeaks& peaks, wire::Snapshot& snapshot);

// Piece "joints", where there are smooth joints, between their particles: normal_force_N, shear_force_N,
// slip_m, opening_m, and peak_slip_m, peak_opening_m over the times that were looked at.
void add_joints(const Observable& observed, const JointPeaks& peaks, wire::Snapshot& snapshot);

}  // namespace adit::dem
