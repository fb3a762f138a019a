// What the parts of a lining have in common: places, names, and the stage in which they are installed.
#pragma once

#include <spdlog/fmt/fmt.h>

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

inline scene::Point point(const geometry::Point& place) {
  scene::Point point;
  point.set_x(place.x);
  point.set_y(place.y);
  return point;
}

// Cells in place of a lattice of discs.
inline bool of_cells(const scene::LinedTunnel& tunnel) {
  return tunnel.particles().has_size();
}

// Half of the distance of neighbouring particles [m].
inline double grain_radius(const scene::LinedTunnel& tunnel) {
  return of_cells(tunnel) ? tunnel.particles().size() / 2 : tunnel.particles().radius();
}

// No place in a hexagonal lattice is farther from a centre, in radii.
inline constexpr double kNearestCentre = 1.16;

// Parts count from 1: `tunnel_joint_1`.
inline std::string part_name(const scene::LinedTunnel& tunnel, const char* part, std::size_t number) {
  return fmt::format("{}_{}_{}", tunnel.name(), part, number);
}

// `resists`: whether it has a strength.
inline std::vector<scene::Quantity> quantities_of_sections(bool resists) {
  std::vector<scene::Quantity> quantities{scene::THRUST, scene::MOMENT, scene::SHEAR_FORCE};
  if (resists) quantities.insert(quantities.end(), {scene::UTILISATION, scene::SHEAR_STRENGTH});
  return quantities;
}

// Of particles or of a continuum.
template <class Model>
scene::History& add_history(Model& model, const std::string& name, scene::Quantity quantity) {
  auto& history = *model.add_histories();
  history.set_name(name);
  history.set_quantity(quantity);
  return history;
}

// 0: it was always there.
inline std::uint32_t stage_of_lining(const scene::LinedTunnel& tunnel) {
  return tunnel.stage() > 0 ? tunnel.stage() + 1 : 0;
}

}  // namespace adit::coupler
