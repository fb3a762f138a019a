#include "fdm_server/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

void require(bool condition, const std::string& path, const std::string& message) {
  if (!condition) throw protocol::UserError(path, message);
}

}  // namespace

Setup read_setup(const scene::Scene& scene) {
  require(scene.has_continuum(), "continuum", "is missing; this server computes a continuum");
  const bool own = scene.continuum().has_material();
  const auto& material = own ? scene.continuum().material() : scene.material();
  const std::string path = own ? "continuum.material" : "material";
  require(own || scene.has_material(), path, "is missing; give it, or continuum.material");
  const double young = material.young_modulus(), poisson = material.poisson_ratio();
  const double density = material.density();
  require(young > 0 && std::isfinite(young), path + ".young_modulus",
          fmt::format("is {} Pa, but must be positive", young));
  require(poisson > -1 && poisson < 0.5, path + ".poisson_ratio",
          fmt::format("is {}, but must lie between -1 and 0.5", poisson));
  require(density > 0 && std::isfinite(density), path + ".density",
          fmt::format("is {} kg/m^3, but must be positive", density));
  return {scene.continuum().zone() == scene::MIXED_DISCRETIZATION ? ZoneKind::kMixedDiscretization
                                                                  : ZoneKind::kAssumedStrain,
          scene.plane() == scene::PLANE_STRESS ? plane_stress(young, poisson) : plane_strain(young, poisson),
          density};
}

}  // namespace adit::fdm
