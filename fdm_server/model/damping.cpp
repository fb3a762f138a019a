#include "fdm_server/model/damping.hpp"

#include "protocol/errors.hpp"

namespace adit::fdm {

using protocol::UserError;

DampingLaw resolve_damping(const scene::Continuum& scene) {
  const scene::Damping& damping = scene.damping();
  if (damping.has_local()) return {.local = damping.local().alpha()};
  if (!damping.has_rayleigh()) {
    if (scene.has_damping())
      throw UserError("continuum.damping", "names no kind; give `rayleigh` or `local`, or leave it out");
    return {};
  }
  const scene::RayleighDamping& given = damping.rayleigh();
  return rayleigh(given.ratio(), given.low_frequency(), given.high_frequency());
}

}  // namespace adit::fdm
