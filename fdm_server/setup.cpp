#include "fdm_server/setup.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "fdm_server/ground.hpp"
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
  return {read_block(scene.continuum().block()),
          scene.continuum().zone() == scene::MIXED_DISCRETIZATION ? ZoneKind::kMixedDiscretization
                                                                  : ZoneKind::kAssumedStrain,
          read_ground(scene)};
}

}  // namespace adit::fdm
