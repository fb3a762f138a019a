// Pieces of a snapshot over particles (wire.proto).
#pragma once

#include <string>
#include <vector>

#include "dem_server/particles/particles.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

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

}  // namespace adit::dem
