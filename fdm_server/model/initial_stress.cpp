#include "fdm_server/model/initial_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/ground/stated_stress.hpp"
#include "protocol/participant/warnings.hpp"

namespace adit::fdm {
namespace {

// The acceleration along y that acts on all the ground for ever [m/s^2]; nothing where another load acts.
std::optional<double> gravity(const scene::Continuum& continuum) {
  double sum = 0;
  for (const scene::BodyLoad& load : continuum.body_loads()) {
    if (load.has_where() || load.has_time()) return std::nullopt;
    sum += load.acceleration().y();
  }
  return sum;
}

}  // namespace

// In balance d yy/dy + d xy/dx + density * gravity = 0. What is left of it over the height of the ground is
// the stress that is lacking at its foot, and half of it in the mean, as half the stress at the foot is the
// mean stress. The horizontal balance is not asked for: below a slope nothing that can be stated has it.
std::optional<std::string> warn_of_imbalance(const scene::Scene& scene, const Grid& grid,
                                             const Ground& ground) {
  constexpr double kLittle = 0.05;
  const auto acceleration = gravity(scene.continuum());
  if (!scene.has_initial_stress() || !scene.has_statics() || !acceleration) return std::nullopt;
  const protocol::StatedStress stated(scene);
  const auto [y_min, y_max] = std::ranges::minmax(grid.y);
  double whole = 0, lacking = 0, stress = 0;  // integrals over the ground
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Corners zone = corners(grid, z);
    const double size = area(zone), h = std::sqrt(size) / 8;
    const auto [x, y] = centroid(zone);
    const double growth = (stated.at(x, y + h).yy - stated.at(x, y - h).yy) / (2 * h) +
                          (stated.at(x + h, y).xy - stated.at(x - h, y).xy) / (2 * h);
    const double weight = ground.materials[ground.of_zone[z]].density * *acceleration;
    whole += size;
    lacking += size * std::abs(growth + weight);
    stress += size * std::abs(stated.at(x, y).yy);
  }
  const double change = lacking / whole * (y_max - y_min) / 2, mean = stress / whole;
  if (!(change > kLittle * mean)) return std::nullopt;
  return protocol::as_warning(fmt::format(
      "initial_stress and gravity do not balance: statics will change the vertical stress by about {:.3g} "
      "kPa "
      "in the mean, where {:.3g} kPa are stated; compare the densities and the sign of body_loads with the "
      "stated growth",
      change / 1e3, mean / 1e3));
}

void set_initial_stress(const scene::Scene& scene, const Grid& grid, ZoneSet& zones) {
  const protocol::StatedStress stated(scene);
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const auto [x, y] = centroid(corners(grid, z));
    const auto [xx, yy, xy, zz] = stated.at(x, y, zones.pore_pressure(z));
    zones.set_stress(z, {xx, yy, xy});
    if (zz) zones.set_stress_zz(z, *zz);
  }
}

}  // namespace adit::fdm
