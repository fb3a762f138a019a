// What the particle part of a scene must fulfil beyond its rules (protocol/scene/fields/check_rules.hpp).
// `path`: where a field stands in the scene, named by the UserError.
#pragma once

#include <string>
#include <vector>

#include "dem_server/model/calibration.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// A snapshot travels in one frame, which limits the particles.
void require_room_for(double particles, double radius, const std::string& path);

// Places and sizes beyond these are slips of a unit or an exponent; their squares stay finite [m].
inline constexpr double kLargestPlace = 1e9, kSmallestRadius = 1e-12;

// Refuses a line whose ends lie closer together than any particle is large: `what` has no direction.
void require_two_ends(const scene::Point& from, const scene::Point& to, const std::string& path,
                      const char* what);

template <class Packing>
geometry::BoundingBox box_of(const Packing& packing) {
  return {packing.x_min(), packing.x_max(), packing.y_min(), packing.y_max()};
}

// The particles' own material, or the scene's.
const scene::Material& material_of(const scene::Scene& scene);

struct MaterialAt {
  const scene::Material& material;
  std::string path;
};
// The same where there is one that bonds can stand for: its path beside it.
MaterialAt checked_material(const scene::Scene& scene);
// The laws of the material, by their keys, that these bonds do not compute: all beyond elasticity, except
// strengths for bonds that take theirs from the material, and `fracture` for facets between cells.
std::vector<std::string> laws_beyond_bonds(const scene::Material& material, const scene::Bonds& bonds,
                                           bool cells);
// Refuses these laws.
void require_usable(const MaterialAt& material, const scene::Bonds& bonds, bool cells);

Plane plane_of(const scene::Scene& scene);

// Stiffnesses of bonds: their own, or calibrated from the material.
BondStiffness checked_stiffness(const scene::Bonds& bonds, const std::string& path,
                                const MaterialAt& material, Plane plane);

}  // namespace adit::dem
