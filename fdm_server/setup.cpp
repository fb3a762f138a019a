#include "fdm_server/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "protocol/errors.hpp"
#include "protocol/frame.hpp"

namespace adit::fdm {
namespace {

void require(bool condition, const std::string& path, const std::string& message) {
  if (!condition) throw protocol::UserError(path, message);
}

Block read_block(const scene::Block& block) {
  const std::string path = "continuum.block.";
  const auto extent = [&path](double min, double max, const std::string& axis) {
    require(std::isfinite(min), path + axis + "_min", "is not finite; give a length in m");
    require(std::isfinite(max), path + axis + "_max", "is not finite; give a length in m");
    require(max > min, path + axis + "_max",
            fmt::format("is {} m, but must be larger than {}_min = {} m", max, axis, min));
  };
  extent(block.x_min(), block.x_max(), "x");
  extent(block.y_min(), block.y_max(), "y");
  require(block.zones_x() > 0, path + "zones_x", "is 0; give at least one zone");
  require(block.zones_y() > 0, path + "zones_y", "is 0; give at least one zone");
  const std::uint64_t points = (std::uint64_t{block.zones_x()} + 1) * (std::uint64_t{block.zones_y()} + 1);
  // A snapshot travels in one frame.
  constexpr std::uint64_t kBytesPerPoint = 180, kMostPoints = protocol::kMaxFrameBytes / kBytesPerPoint;
  require(points <= kMostPoints, path + "zones_x",
          fmt::format("and zones_y make {} grid points; at most {} can be computed, use larger zones", points,
                      kMostPoints));
  return {block.x_min(), block.x_max(), block.y_min(), block.y_max(), block.zones_x(), block.zones_y()};
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
  return {read_block(scene.continuum().block()),
          scene.continuum().zone() == scene::MIXED_DISCRETIZATION ? ZoneKind::kMixedDiscretization
                                                                  : ZoneKind::kAssumedStrain,
          scene.plane() == scene::PLANE_STRESS ? plane_stress(young, poisson) : plane_strain(young, poisson),
          density};
}

}  // namespace adit::fdm
