#include "fdm_server/model/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "fdm_server/model/ground.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
Setup read_setup(const scene::Scene& scene) {
  protocol::require(scene.has_continuum(), "continuum", "is missing; this server computes a continuum");
  return {scene.continuum().zone() == scene::MIXED_DISCRETIZATION ? ZoneKind::kMixedDiscretization
                                                                  : ZoneKind::kAssumedStrain,
          read_ground(scene)};
}

}  // namespace adit::fdm
