// From the scene to the continuum's plain parameters.
#pragma once

#include "fdm_server/zones/plane_law.hpp"
#include "fdm_server/zones/zones.hpp"
#include "protocol/scene.pb.h"

namespace adit::fdm {

struct Setup {
  ZoneKind kind;
  PlaneLaw law;
  double density;  // [kg/m^3]
};

// UserError with the field's path where a value is missing or no continuum can be built of it.
Setup read_setup(const scene::Scene& scene);

}  // namespace adit::fdm
