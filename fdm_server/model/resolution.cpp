#include "fdm_server/model/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/motion/measures.hpp"

namespace adit::fdm {
namespace {

constexpr double kZonesAWavelength = 10;
constexpr double kShareThatMatters = 0.99;

double longest_side(const Corners& corners, double width, double height) {
  constexpr double kWhole = 1 - 1e-9;
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const double dx = std::abs(corners.x[next] - corners.x[i]), dy = std::abs(corners.y[next] - corners.y[i]);
    if (dx < kWhole * width && dy < kWhole * height) longest = std::max(longest, std::hypot(dx, dy));
  }
  return longest;
}

}  // namespace

Resolution resolution(const Grid& grid, const Ground& ground) {
  const auto box = bounds(grid);
  Resolution least{HUGE_VAL, 0, 0, 0};
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const double speed = std::sqrt(ground.plane_law(z).shear / ground.material(z).density);
    const double size = longest_side(corners(grid, z), box.x_max - box.x_min, box.y_max - box.y_min);
    const double frequency = speed / (kZonesAWavelength * size);
    if (frequency < least.frequency) least = {frequency, speed, size, ground.stated_of(z)};
  }
  if (!std::isfinite(least.frequency)) least.frequency = 0;  // a single zone, or a single row across the grid
  return least;
}

std::optional<std::string> note_on_resolution(const Resolution& resolution, const scene::Continuum& scene,
                                              const motion::Motion& motion) {
  if (motion.acceleration.empty() || resolution.frequency == 0) return std::nullopt;
  const scene::GroundMotion& given = scene.base().acceleration();
  const double matters =
      given.has_high_corner() ? given.high_corner() : motion::frequency_below(motion, kShareThatMatters);
  if (resolution.frequency >= matters) return std::nullopt;
  return fmt::format(
      "zones of {} (c_s {:.3g} m/s, sides up to {:.3g} m) carry shear waves well up to {:.2g} Hz, with {:g} "
      "zones a "
      "wavelength, but {} {:.2g} Hz, where there are {:.2g}; make them at most {:.2g} m",
      resolution.material == 0 ? "`material`" : fmt::format("`materials[{}]`", resolution.material - 1),
      resolution.speed, resolution.size, resolution.frequency, kZonesAWavelength,
      given.has_high_corner() ? "`high_corner` lets the motion pass up to"
                              : "99 % of the motion's energy reach up to",
      matters, resolution.speed / (matters * resolution.size),
      resolution.speed / (kZonesAWavelength * matters));
}

}  // namespace adit::fdm
