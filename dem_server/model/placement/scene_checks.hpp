// What the particle part of a scene must fulfil beyond the limits of single fields. `path`: where a field
// stands in the scene, named by the UserError.
#pragma once

#include <string>

#include "dem_server/engines/lattice/contact_forces.hpp"
#include "dem_server/packing/hexagonal.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

void require_positive(double value, const std::string& path, const std::string& unit);

// A snapshot travels in one frame, which limits the particles.
void require_room_for(double particles, double radius, const std::string& path);

Rectangle checked_box(const Rectangle& box, const std::string& path);

template <class Packing>
Rectangle checked_box(const Packing& packing, const std::string& path) {
  return checked_box(Rectangle{packing.x_min(), packing.x_max(), packing.y_min(), packing.y_max()}, path);
}

// The particles' own material, or the scene's.
const scene::Material& material_of(const scene::Scene& scene);

struct MaterialAt {
  const scene::Material& material;
  std::string path;
};
// The same where there is one, and elastic: its path beside it.
MaterialAt checked_material(const scene::Scene& scene);
void require_elastic(const MaterialAt& material);

Plane plane_of(const scene::Scene& scene);

// Stiffnesses of bonds: their own, or calibrated from the material.
BondStiffness checked_stiffness(const scene::Bonds& bonds, const std::string& path,
                                const MaterialAt& material, Plane plane);

// The packing that the scene asks for. UserError at particles.packing: no box, no particles, too many.
Packing checked_packing(const scene::Scene& scene);

// Stiffnesses and strengths. UserError at material or particles.bonds.
BondLaw checked_bond_law(const scene::Scene& scene);

}  // namespace adit::dem
