// What joins two discs, before their sizes are known.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "dem_server/model/calibration.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/model/solid/strength_of_material.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Of the solid and of its strength, before a facet's place is known.
struct FacetType {
  double stiffness;  // E' [Pa]
  FacetLaw law;
};

struct BondType {
  // Lengths are shares: of a parallel bond its half width of the smaller radius, of a smooth joint its length
  // of the smaller diameter.
  std::variant<ContactBond, ParallelBond, SmoothJoint, FacetType> law;
  double reach;  // discs are joined whose gap is at most this share of their mean radius
};

// What the bonds of a scene take from elsewhere.
struct BondSource {
  std::function<BondStiffness()> stiffness;  // of a contact bond, where the scene leaves it out
  // Of the material, the weaker one where there are two; asked for only with `strength_of_material`. A path.
  std::function<MaterialStrength(const std::string& path)> strength;
  std::optional<double> lattice_radius;  // of the particles, where they are packed hexagonally [m]
  double reach;                          // of bonds that state none
};
// UserError below `path` for strengths that are given twice or cannot be had.
BondType read_bond_type(const scene::Bonds& bonds, const std::string& path, const BondSource& source);
BondType read_smooth_joint(const scene::SmoothJoint& joint, double reach);

// Between discs of two groups: stiffnesses in series, the smaller strengths, width and reach. No value for
// two laws of different kinds.
std::optional<BondType> between(const BondType& a, const BondType& b);

}  // namespace adit::dem
