#include "fdm_server/model/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "fdm_server/model/ground.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

void require(bool condition, const std::string& path, const std::string& message) {
  if (!condition) throw protocol::UserError(path, message);
}

}  // namespace

Setup read_setup(const scene::Scene& scene) {
  require(scene.has_continuum(), "continuum", "is missing; this server computes a continuum");
  return {scene.continuum().zone() == scene::MIXED_DISCRETIZATION ? ZoneKind::kMixedDiscretization
                                                                  : ZoneKind::kAssumedStrain,
          read_ground(scene)};
}

}  // namespace adit::fdm
