#include "dem_server/model/initial_state/outside.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {
namespace {

double size(const protocol::GroundStress& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.xy)});
}

// At a height from which two diameters downwards the stress grows by as much as it is.
bool vanishes(const StressAtHeight& stated, double y, double radius) {
  const auto here = stated(y), below = stated(y - 4 * radius);
  return size(here) <= size({below.xx - here.xx, below.yy - here.yy, below.xy - here.xy, {}});
}

}  // namespace

std::vector<double> external_forces(const Model& model) {
  std::vector<double> forces(3 * model.discs.size(), 0.0);
  for (const Load& load : model.loads) {
    const double factor = load.time(0);
    for (const std::uint32_t i : load.discs) {
      const double share =
          load.kind == Load::Kind::kForce ? 1 / static_cast<double>(load.discs.size()) : model.mass[i];
      forces[3 * i] += factor * share * load.x;
      forces[3 * i + 1] += factor * share * load.y;
    }
  }
  for (const Spring& spring : model.springs) {
    if (spring.stage > 0) continue;
    const double x = model.discs.x[spring.second] - model.discs.x[spring.first],
                 y = model.discs.y[spring.second] - model.discs.y[spring.first];
    const double per_length = spring.pretension / std::hypot(x, y);
    forces[3 * spring.first] += per_length * x;
    forces[3 * spring.first + 1] += per_length * y;
    forces[3 * spring.second] -= per_length * x;
    forces[3 * spring.second + 1] -= per_length * y;
  }
  return forces;
}

std::vector<bool> held_motions(const Model& model, const std::vector<bool>& border,
                               const StressAtHeight& stated) {
  const std::size_t discs = model.discs.size();
  std::vector<bool> held(3 * discs, false), of_scene(discs, false);
  for (const PrescribedMotion& motion : model.motions)
    for (const std::uint32_t i : motion.discs) {
      held[3 * i + static_cast<std::size_t>(motion.component)] = true;
      of_scene[i] = true;
    }
  for (const EdgeDashpot& edge : model.edges) {
    held[3 * edge.disc] = held[3 * edge.disc + 1] = true;
    of_scene[edge.disc] = true;
  }
  for (const Load& load : model.loads)
    if (load.kind == Load::Kind::kForce && load.time(0) != 0)
      for (const std::uint32_t i : load.discs) of_scene[i] = true;
  for (std::size_t i = 0; i < discs; ++i)
    if (border[i] && !of_scene[i] && !vanishes(stated, model.discs.y[i], model.discs.radius[i]))
      held[3 * i] = held[3 * i + 1] = held[3 * i + 2] = true;
  return held;
}

}  // namespace adit::dem
