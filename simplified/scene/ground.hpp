// The scene's ground along the tunnel: profiles between the given ones, soil columns, soil springs.
#pragma once

#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/column/joined_columns.hpp"

namespace adit::simplified {

enum Direction { kAxial, kLateral, kVertical };
inline constexpr int kDirections = 3;

// Throws UserError at "simplified.ground.profiles…" for chainages that do not increase and profiles with
// different numbers of layers.
void check(const scene::Ground& ground);

// Thickness and properties layer by layer, linear between the profiles.
scene::SoilProfile profile_at(const scene::Ground& ground, double chainage);

// Columns at equal distances of at most column_spacing from `begin` to `end`, for waves of shear (horizontal
// directions) or of compression.
std::vector<column::Column> columns(const scene::Ground& ground, double begin, double end,
                                    Direction direction);

// Of the soil's longitudinal springs in the direction (column/joined_columns.hpp); 0 where columns are not
// joined.
double modulus_ratio(const scene::Ground& ground, Direction direction);

struct SoilStiffness {
  double axial, lateral, vertical;  // per metre of tunnel [N/m^2]
};

// Given, or K = 16 pi G (1 - nu) / (3 - 4 nu) d / L by St John and Zahrah (1987, eq. 21), d the section's
// width [m], as the mean over the section's height: springs of all layers beside it act in parallel, and the
// tunnel passes from one layer to the next gradually. Throws UserError where a stiffness is to be derived and
// the ground or the wavelength is missing.
SoilStiffness soil_stiffness(const scene::Simplified& scene, double chainage, const scene::Section& section);

}  // namespace adit::simplified
