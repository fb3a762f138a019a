#include "dem_server/model/initial_state/outside.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {
namespace {

double size(const protocol::GroundStress& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.xy)});
}

// At a place from which two diameters downwards the stress grows by as much as it is.
bool vanishes(const StressAt& stated, double x, double y, double radius) {
  const auto here = stated(x, y), below = stated(x, y - 4 * radius);
  return size(here) <= size({below.xx - here.xx, below.yy - here.yy, below.xy - here.xy, {}});
}

struct Corner {
  double x, y, weight;
};

// -(s . grad phi) times twice the area of a triangle, phi being 1 at one corner and 0 at the next two,
// counter-clockwise.
PlaneVector pull(const protocol::GroundStress& s, const Corner& next, const Corner& last) {
  const double nx = next.y - last.y, ny = last.x - next.x;
  return {-(s.xx * nx + s.xy * ny), -(s.xy * nx + s.yy * ny)};
}

// What a face adds to T; `inner` is w_i of each disc, 0 at the outermost ones.
void add_face(const Discs& d, const Face& face, std::span<const double> weights,
              const std::vector<double>& inner, const protocol::GroundStress& s,
              std::vector<double>& forces) {
  const std::size_t n = face.corners.size();
  const double share = 1 / static_cast<double>(n);
  const auto corner = [&](std::size_t k) {
    const std::uint32_t i = face.corners[k % n];
    return Corner{d.x[i], d.y[i], weights[i]};
  };
  const auto add = [&](std::size_t k, double mean, const PlaneVector& pull, double part) {
    const std::uint32_t i = face.corners[k % n];
    forces[3 * i] += part * (mean - inner[i]) / 2 * pull.x;
    forces[3 * i + 1] += part * (mean - inner[i]) / 2 * pull.y;
  };
  Corner middle{0, 0, 0};
  for (std::size_t k = 0; k < n; ++k) {
    const auto [x, y, weight] = corner(k);
    middle.x += share * x, middle.y += share * y, middle.weight += share * weight;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Corner a = corner(k), b = corner(k + 1);
    const double mean = (middle.weight + a.weight + b.weight) / 3;
    add(k, mean, pull(s, b, middle), 1);
    add(k + 1, mean, pull(s, middle, a), 1);
    for (std::size_t other = 0; other < n; ++other) add(other, mean, pull(s, a, b), share);
  }
}

}  // namespace

std::vector<double> forces_of_overlap(const Discs& discs, const Faces& faces, std::span<const double> weights,
                                      const StressAt& stated) {
  std::vector<double> forces(3 * discs.size(), 0.0), inner(weights.begin(), weights.end());
  for (std::size_t i = 0; i < inner.size(); ++i)
    if (faces.border[i] && weights[i] < kShared) inner[i] = 0;
  for (const Face& face : faces.inside) add_face(discs, face, weights, inner, stated(face.x, face.y), forces);
  for (double& force : forces) force = -force;
  return forces;
}

std::vector<double> external_forces(const Model& model) {
  std::vector<double> forces(3 * model.discs.size(), 0.0);
  for (const Load& load : model.loads) {
    const double factor = load.time(0);
    std::vector<std::uint32_t> loaded = load.discs;
    std::erase_if(loaded, [&](std::uint32_t i) { return !model.is_there(i); });
    for (const std::uint32_t i : loaded) {
      const double share = load.kind == Load::Kind::kForce ? 1 / static_cast<double>(loaded.size())
                                                           : model.weight[i] * model.mass[i];
      forces[3 * i] += factor * share * load.x;
      forces[3 * i + 1] += factor * share * load.y;
    }
  }
  for (const Spring& spring : model.springs) {
    if (spring.stage > 0 || !model.is_there(spring.first) || !model.is_there(spring.second)) continue;
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

std::vector<bool> held_motions(const Model& model, const std::vector<bool>& border, const StressAt& stated) {
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
    if (border[i] && !of_scene[i] &&
        !vanishes(stated, model.discs.x[i], model.discs.y[i], model.discs.radius[i]))
      held[3 * i] = held[3 * i + 1] = held[3 * i + 2] = true;
  return held;
}

}  // namespace adit::dem
