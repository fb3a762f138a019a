#include "fdm_server/model/damping.hpp"

#include <fmt/format.h>

#include <string>

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
  const std::string path = "continuum.damping.rayleigh.";
  const auto require_positive = [&](double value, const char* field) {
    if (!(value > 0)) throw UserError(path + field, fmt::format("is {}, but must be above 0", value));
  };
  require_positive(given.ratio(), "ratio");
  require_positive(given.low_frequency(), "low_frequency");
  if (given.high_frequency() < given.low_frequency())
    throw UserError(path + "high_frequency",
                    fmt::format("is {} Hz, below low_frequency = {} Hz; exchange them",
                                given.high_frequency(), given.low_frequency()));
  return rayleigh(given.ratio(), given.low_frequency(), given.high_frequency());
}

}  // namespace adit::fdm
