// How one property of a model differs from place to place: the `scatter` of a continuum or of particles.
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/materials.pb.h"
#include "protocol/scatter/factor_field.hpp"

namespace adit::protocol {

using ScatterFields = google::protobuf::RepeatedPtrField<scene::Scatter>;

class Scattering {
 public:
  // Of all fields of the property. `path`: of their list in the scene. Throws UserError at
  // `path`[k].path where a field's file is none (factor_field.hpp).
  Scattering(const ScatterFields& fields, scene::Scatter::Property property, const std::string& path);

  // Whether no field is of the property, so that every factor is 1.
  bool empty() const { return fields_.empty(); }
  // The product of the fields' factors at a place [m].
  double at(double x, double y) const;

 private:
  std::vector<FactorField> fields_;
};

}  // namespace adit::protocol
