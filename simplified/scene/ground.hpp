// The scene's ground along the tunnel: interpolated soil profiles, soil columns and soil springs.
#pragma once

#include <functional>
#include <vector>

#include "protocol/messages/scene.pb.h"
#include "simplified/column/joined_columns.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {

enum Direction { kAxial, kLateral, kVertical };
inline constexpr int kDirections = 3;

// Throws UserError at "simplified.ground.profiles…" if chainages do not increase or if profiles have
// different numbers of layers.
void check(const scene::Ground& ground);

// The profile at a chainage: thickness and properties of each layer are linear between the given profiles. Of
// the cyclic resistance it is the inverse, which is 0 where a layer does not liquefy: towards a profile
// without liquefaction the resistance grows without bound.
scene::SoilProfile profile_at(const scene::Ground& ground, double chainage);

// Columns at equal distances of at most column_spacing from `begin` to `end`, for waves of shear (horizontal
// directions) or of compression.
std::vector<column::Column> columns(const scene::Ground& ground, double begin, double end,
                                    Direction direction);

// The mean of a value of the layers over the tunnel's height; the lowest layer continues below its bottom.
double mean_over(const scene::SoilProfile& profile, Heights heights,
                 const std::function<double(const scene::Layer&)>& value);

struct SoilStiffness {
  double axial, lateral, vertical;  // per metre of tunnel [N/m^2]
};

// The stiffness as given in the scene, or else K = 16 pi G (1 - nu) / (3 - 4 nu) d / L by St John and Zahrah
// (1987, eq. 21), where d is the width of the section [m] and L the wavelength. The modulus is the mean over
// the height of the section, because the springs of all layers beside it act in parallel; so K changes
// gradually where the tunnel passes from one layer to the next. Throws UserError if the ground or the
// wavelength is missing for this.
SoilStiffness soil_stiffness(const scene::Simplified& scene, double chainage, const scene::Section& section);

}  // namespace adit::simplified
