// From the scene to the continuum's plain parameters.
#pragma once

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct Setup {
  ZoneKind kind;
  Ground ground;  // its zones not yet assigned
};

// UserError with the field's path where a value is missing or no continuum can be built of it.
Setup read_setup(const scene::Scene& scene);

}  // namespace adit::fdm
